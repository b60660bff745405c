#include "pliant/capture/tag_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "pliant/capture/pattern.h"

namespace pliant {
namespace {

// Cells of a tag's side; the outermost are black, and beside them the paper is white.
constexpr double kCells = kTagCells;
constexpr double kNarrow = 4;  // pixels of a cell
// Places nearer than this share of the side to a corner see the other edge through the blur.
constexpr double kLeftOut = 0.08;
constexpr int kFewestPlaces = 6;
// A parabola is the lens's where its bend is so many times its own error; else it is noise.
constexpr double kClearBend = 8;
constexpr int kFewestForBend = 40;         // places; short edges are straight
constexpr double kLeast = 1, kWidest = 3;  // pixels across an edge that are looked at
// In smaller cells the blur of both of their edges is one.
constexpr double kLeastDepth = 2;  // pixels
constexpr double kFurthest = 2.5;  // pixels that a corner may move

// One edge: from a corner along `along` (unit) for `length` pixels; it lies `offset` pixels beside
// that chord, towards `across`, at t from 0 to 1.
struct TagEdge {
  Eigen::Vector2d from, along, across;
  double length = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // factors of 1, t, t^2
  Eigen::Vector3d line = Eigen::Vector3d::Zero();    // the same, without t^2

  TagEdge(const Eigen::Vector2d& corner, const Eigen::Vector2d& next)
      : from(corner),
        along((next - corner).normalized()),
        across(-along.y(), along.x()),
        length((next - corner).norm()) {}

  Eigen::Vector2d on_chord(double t) const { return from + t * length * along; }
  double beside(double t) const { return offset(0) + t * (offset(1) + t * offset(2)); }
  Eigen::Vector2d at(double t) const { return on_chord(t) + beside(t) * across; }
  Eigen::Vector2d slope(double t) const {
    return length * along + (offset(1) + 2 * t * offset(2)) * across;
  }
};

// Brightness between pixels. By the four around it does not ring beside edges, which would move the
// middle of their gradient; where cells are narrower than that blurs them, by splines.
class EdgePicture {
 public:
  /// @param corners  of a tag, about which the picture is looked at
  EdgePicture(const GreyPicture& pixels, const TagCorners& corners) : pixels_(pixels) {
    constexpr double kAround = 8;  // pixels, more than is looked at
    if ((corners.col(1) - corners.col(0)).norm() >= kCells * kNarrow) return;
    const Eigen::Array2i size(static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()));
    const Eigen::Array2i first =
        (corners.rowwise().minCoeff().array() - kAround).cast<int>().max(0);
    const Eigen::Array2i last =
        (corners.rowwise().maxCoeff().array() + kAround).cast<int>().min(size - 1);
    first_ = first.cast<double>();
    spline_.emplace(
        pixels.block(first.y(), first.x(), last.y() - first.y() + 1, last.x() - first.x() + 1));
  }

  bool has_narrow_cells() const { return spline_.has_value(); }

  std::optional<double> at(const Eigen::Vector2d& place) const {
    if (!spline_) return by_four(place);
    if (!spline_->contains(place - first_)) return std::nullopt;
    return static_cast<double>(spline_->sample(place - first_).value);
  }

 private:
  std::optional<double> by_four(const Eigen::Vector2d& at) const;

  const GreyPicture& pixels_;
  std::optional<SplinePicture> spline_;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero();  // pixel of the spline
};

std::optional<double> EdgePicture::by_four(const Eigen::Vector2d& at) const {
  const auto column = static_cast<Eigen::Index>(std::floor(at.x()));
  const auto row = static_cast<Eigen::Index>(std::floor(at.y()));
  if (column < 0 || row < 0 || column + 1 >= pixels_.cols() || row + 1 >= pixels_.rows()) {
    return std::nullopt;
  }
  const double x = at.x() - static_cast<double>(column), y = at.y() - static_cast<double>(row);
  return (1 - y) * ((1 - x) * pixels_(row, column) + x * pixels_(row, column + 1)) +
         y * ((1 - x) * pixels_(row + 1, column) + x * pixels_(row + 1, column + 1));
}

// Where the brightness changes across an edge, and how widely.
struct EdgePlace {
  double middle = 0;  // of the gradient (pixels)
  double square = 0;  // its second moment about the middle (pixels^2)
};

// How far an edge is looked for, and how much of the picture about it tells where it is (pixels).
struct EdgeReach {
  double furthest = 0, window = 0;
};

// Looks about a middle, at which the window is laid again.
std::optional<EdgePlace> edge_across(const EdgePicture& picture, const Eigen::Vector2d& place,
                                     const Eigen::Vector2d& across, double middle,
                                     const EdgeReach& reach) {
  constexpr double kStep = 0.25;
  constexpr int kRounds = 4;
  const int steps = static_cast<int>(std::ceil(reach.window / kStep));
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0, moment = 0, square = 0, before = 0;
    for (int i = -steps; i <= steps; ++i) {
      const auto now = picture.at(place + (middle + i * kStep) * across);
      if (!now) return std::nullopt;
      if (i > -steps) {
        const double change = *now - before, off = (i - 0.5) * kStep;
        sum += change;
        moment += change * off;
        square += change * off * off;
      }
      before = *now;
    }
    if (!(sum > 0)) return std::nullopt;  // it gets brighter outwards
    const double step = moment / sum;
    middle += step;
    if (std::abs(middle) > reach.furthest) return std::nullopt;
    if (std::abs(step) < 1e-3 || round == kRounds - 1) return EdgePlace{middle, square / sum};
  }
  return std::nullopt;
}

// Places along an edge: t from 0 to 1, and pixels beside it.
using EdgePlaces = std::vector<Eigen::Vector2d>;

Eigen::MatrixXd powers_of(const EdgePlaces& places, int terms) {
  Eigen::MatrixXd powers(std::ssize(places), terms);
  for (int i = 0; i < std::ssize(places); ++i) {
    for (int k = 0; k < terms; ++k) powers(i, k) = std::pow(places[i].x(), k);
  }
  return powers;
}

/// @param weights  of the places
/// @return the factors of 1, t, t^2
Eigen::Vector3d polynomial(const EdgePlaces& places, const Eigen::VectorXd& weights, int terms) {
  Eigen::VectorXd offsets(std::ssize(places));
  for (int i = 0; i < std::ssize(places); ++i) offsets(i) = weights(i) * places[i].y();
  Eigen::Vector3d factors = Eigen::Vector3d::Zero();
  factors.head(terms) =
      (weights.asDiagonal() * powers_of(places, terms)).colPivHouseholderQr().solve(offsets);
  return factors;
}

struct RobustPolynomial {
  Eigen::Vector3d factors;
  double error = 0;         // standard, of the last factor
  Eigen::VectorXd weights;  // 0 where a place is off, else 1
};

/// Again and again without places that are off: a scratch, a finger, a cord that hides a fifth of
/// the edge.
/// @return nothing where too few places are left
std::optional<RobustPolynomial> robust_polynomial(const EdgePlaces& places, int terms) {
  constexpr int kRounds = 6;
  const auto count = std::ssize(places);
  const Eigen::MatrixXd powers = powers_of(places, terms);
  RobustPolynomial fit{{}, 0, Eigen::VectorXd::Ones(count)};
  double squares = 0;
  for (int round = 0; round < kRounds; ++round) {
    fit.factors = polynomial(places, fit.weights, terms);
    Eigen::ArrayXd missed = powers * fit.factors.head(terms);
    for (int i = 0; i < count; ++i) missed(i) = std::abs(missed(i) - places[i].y());
    std::vector<double> sorted(missed.begin(), missed.end());
    std::ranges::nth_element(sorted, sorted.begin() + count / 2);
    const double limit = std::max(0.05, 4 * sorted[count / 2]);
    fit.weights = (missed < limit).cast<double>();
    squares = (fit.weights.array() * missed.square()).sum();
    if (fit.weights.sum() < kFewestPlaces) return std::nullopt;
  }
  const Eigen::MatrixXd normal = powers.transpose() * fit.weights.asDiagonal() * powers;
  const double spare = std::max(fit.weights.sum() - terms, 1.0);
  fit.error = std::sqrt(normal.inverse()(terms - 1, terms - 1) * squares / spare);
  return fit;
}

bool fit_edge(TagEdge& edge, const EdgePlaces& places) {
  if (std::ssize(places) < kFewestPlaces) return false;
  if (std::ssize(places) >= kFewestForBend) {
    const auto bent = robust_polynomial(places, 3);
    if (bent && std::abs(bent->factors(2)) > kClearBend * bent->error) {
      edge.offset = bent->factors;
      edge.line = polynomial(places, bent->weights, 2);
      return true;
    }
  }
  const auto straight = robust_polynomial(places, 2);
  if (!straight) return false;
  edge.offset = edge.line = straight->factors;
  return true;
}

// Lays an edge through the places where the brightness changes.
// @return the width of the change, its root mean square about the edge (pixels)
std::optional<double> find_edge(const EdgePicture& picture, TagEdge& edge, const EdgeReach& reach) {
  const int count = static_cast<int>(edge.length * (1 - 2 * kLeftOut));
  EdgePlaces places;
  double squares = 0;
  for (int i = 0; i <= count; ++i) {
    const double t = kLeftOut + (1 - 2 * kLeftOut) * i / std::max(count, 1);
    const auto found = edge_across(picture, edge.on_chord(t), edge.across, edge.beside(t), reach);
    if (!found) continue;
    places.emplace_back(t, found->middle);
    squares += found->square;
  }
  if (!fit_edge(edge, places)) return std::nullopt;
  return std::sqrt(std::max(squares, 0.0) / static_cast<double>(places.size()));
}

/// @param edge  the chord between two corners of a tag
/// @param middle  of the tag
bool find_whole_edge(const EdgePicture& picture, TagEdge& edge, const Eigen::Vector2d& middle) {
  if (edge.across.dot(edge.from - middle) < 0) edge.across = -edge.across;
  // Half of what a foreshortened cell measures, at most: beyond it are the cells of the code.
  const double depth = std::abs(edge.across.dot(edge.from - middle)) * 2 / kCells;
  if (depth < kLeastDepth) return false;
  const double reach = std::clamp(0.5 * depth, kLeast, kWidest);
  const auto width = find_edge(picture, edge, {reach, reach});
  if (!width) return false;
  if (picture.has_narrow_cells()) return true;  // which have no more
  // What is further from the edge than its blur tells noise alone, and what is as near to the other
  // edge of its cells would draw it outwards.
  const double blur = 3 * *width;
  const double window = std::clamp(std::min(blur, depth - blur), kLeast, reach);
  return find_edge(picture, edge, {reach, window}).has_value();
}

// The end of one edge and the start of the next.
std::optional<Eigen::Vector2d> meeting(const TagEdge& first, const TagEdge& second) {
  Eigen::Vector2d t(1, 0);
  for (int round = 0; round < 8; ++round) {
    Eigen::Matrix2d slopes;
    slopes << first.slope(t(0)), -second.slope(t(1));
    const Eigen::Vector2d apart = first.at(t(0)) - second.at(t(1));
    const Eigen::Vector2d step = slopes.partialPivLu().solve(apart);
    if (!step.allFinite()) return std::nullopt;
    t -= step;
  }
  return first.at(t(0));
}

// Nothing where two edges do not meet near the corners.
std::optional<TagCorners> meetings(const std::array<TagEdge, 4>& edges, const TagCorners& corners) {
  TagCorners result;
  for (int i = 0; i < 4; ++i) {
    const auto corner = meeting(edges[(i + 3) % 4], edges[i]);
    if (!corner || !((*corner - corners.col(i)).norm() < kFurthest)) return std::nullopt;
    result.col(i) = *corner;
  }
  return result;
}

std::array<TagEdge, 4> chords_of(const TagCorners& corners) {
  return {TagEdge(corners.col(0), corners.col(1)), TagEdge(corners.col(1), corners.col(2)),
          TagEdge(corners.col(2), corners.col(3)), TagEdge(corners.col(3), corners.col(0))};
}

// Where the lens shows the places along an edge that lines are laid through.
std::optional<EdgePlaces> places_of_bent(const TagEdge& edge, const CameraModel& camera) {
  constexpr int kPlaces = 25;
  const auto from = camera.straight(edge.at(0)), to = camera.straight(edge.at(1));
  if (!from || !to) return std::nullopt;
  EdgePlaces places;
  for (int i = 0; i < kPlaces; ++i) {
    const double along = kLeftOut + (1 - 2 * kLeftOut) * i / (kPlaces - 1);
    const Eigen::Vector2d straight = (1 - along) * *from + along * *to;
    const Eigen::Vector2d off =
        pixel_of(camera.intrinsics.data(), Eigen::Vector3d(straight.homogeneous())) - edge.from;
    places.emplace_back(off.dot(edge.along) / edge.length, off.dot(edge.across));
  }
  return places;
}

}  // namespace

EdgeCorners corners_by_edges(const GreyPicture& pixels, const TagCorners& corners) {
  const Eigen::Vector2d middle = corners.rowwise().mean();
  const EdgePicture picture(pixels, corners);
  std::array<TagEdge, 4> edges = chords_of(corners);
  for (TagEdge& edge : edges) {
    if (!find_whole_edge(picture, edge, middle)) return {corners, corners};
  }
  const auto bent = meetings(edges, corners);
  for (TagEdge& edge : edges) edge.offset = edge.line;
  const auto straight = meetings(edges, corners);
  if (!bent || !straight) return {corners, corners};
  return {*bent, *straight};
}

TagCorners corners_by_lens(const TagCorners& of_lines, const CameraModel& camera) {
  // Taken for the corners, those of lines are bent by nearly as much.
  std::array<TagEdge, 4> edges = chords_of(of_lines);
  for (TagEdge& edge : edges) {
    const auto places = places_of_bent(edge, camera);
    if (!places) return of_lines;
    edge.offset = polynomial(*places, Eigen::VectorXd::Ones(std::ssize(*places)), 2);
  }
  const auto shown = meetings(edges, of_lines);
  return shown ? TagCorners(2 * of_lines - *shown) : of_lines;
}

}  // namespace pliant
