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

using TagCorners = Eigen::Matrix<double, 2, 4>;

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

// One edge: from a corner along `along` (unit) for `length` pixels; it lies `offset(t)` pixels
// beside that line, towards `across`, at t from 0 to 1.
struct TagEdge {
  Eigen::Vector2d from, along, across;
  double length = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // of 1, t, t^2

  Eigen::Vector2d on_line(double t) const { return from + t * length * along; }
  double beside(double t) const { return offset(0) + t * (offset(1) + t * offset(2)); }
  Eigen::Vector2d at(double t) const { return on_line(t) + beside(t) * across; }
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

/// The polynomial of some terms through places along an edge (t, offset), again and again without
/// places that are off: a scratch, a finger, a cord that hides a fifth of it.
/// @return the standard error of the last term; nothing where too few places are left
std::optional<double> fit_terms(int terms, const std::vector<Eigen::Vector2d>& places,
                                Eigen::Vector3d& offset) {
  const auto count = std::ssize(places);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count), offsets(count);
  Eigen::MatrixXd powers(count, terms);
  for (int i = 0; i < count; ++i) {
    offsets(i) = places[i].y();
    for (int k = 0; k < terms; ++k) powers(i, k) = std::pow(places[i].x(), k);
  }
  double squares = 0;
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    offset.setZero();
    offset.head(terms) =
        (weights.asDiagonal() * powers).colPivHouseholderQr().solve(weights.cwiseProduct(offsets));
    const Eigen::ArrayXd missed = (powers * offset.head(terms) - offsets).array().abs();
    std::vector<double> sorted(missed.begin(), missed.end());
    std::ranges::nth_element(sorted, sorted.begin() + count / 2);
    const double limit = std::max(0.05, 4 * sorted[count / 2]);
    weights = (missed < limit).cast<double>();
    squares = (weights.array() * missed.square()).sum();
    if (weights.sum() < kFewestPlaces) return std::nullopt;
  }
  const Eigen::MatrixXd normal = powers.transpose() * weights.asDiagonal() * powers;
  const double spare = std::max(weights.sum() - terms, 1.0);
  return std::sqrt(normal.inverse()(terms - 1, terms - 1) * squares / spare);
}

bool fit_edge(TagEdge& edge, const std::vector<Eigen::Vector2d>& places) {
  if (std::ssize(places) < kFewestPlaces) return false;
  if (std::ssize(places) >= kFewestForBend) {
    const auto error = fit_terms(3, places, edge.offset);
    if (error && std::abs(edge.offset(2)) > kClearBend * *error) return true;
  }
  return fit_terms(2, places, edge.offset).has_value();
}

// Lays an edge through the places where the brightness changes.
// @return the width of the change, its root mean square about the edge (pixels)
std::optional<double> find_edge(const EdgePicture& picture, TagEdge& edge, const EdgeReach& reach) {
  const int count = static_cast<int>(edge.length * (1 - 2 * kLeftOut));
  std::vector<Eigen::Vector2d> places;
  double squares = 0;
  for (int i = 0; i <= count; ++i) {
    const double t = kLeftOut + (1 - 2 * kLeftOut) * i / std::max(count, 1);
    const auto found = edge_across(picture, edge.on_line(t), edge.across, edge.beside(t), reach);
    if (!found) continue;
    places.emplace_back(t, found->middle);
    squares += found->square;
  }
  if (!fit_edge(edge, places)) return std::nullopt;
  return std::sqrt(std::max(squares, 0.0) / static_cast<double>(places.size()));
}

std::optional<TagEdge> edge_between(const EdgePicture& picture, const Eigen::Vector2d& from,
                                    const Eigen::Vector2d& to, const Eigen::Vector2d& middle) {
  TagEdge edge;
  edge.from = from;
  edge.length = (to - from).norm();
  edge.along = (to - from) / edge.length;
  edge.across = Eigen::Vector2d(-edge.along.y(), edge.along.x());
  if (edge.across.dot(from - middle) < 0) edge.across = -edge.across;
  // Half of what a foreshortened cell measures, at most: beyond it are the cells of the code.
  const double depth = std::abs(edge.across.dot(from - middle)) * 2 / kCells;
  if (depth < kLeastDepth) return std::nullopt;
  const double reach = std::clamp(0.5 * depth, kLeast, kWidest);
  const auto width = find_edge(picture, edge, {reach, reach});
  if (!width) return std::nullopt;
  // What is further from the edge than its blur tells noise alone. Narrow cells have no more.
  if (picture.has_narrow_cells()) return edge;
  if (!find_edge(picture, edge, {reach, std::clamp(3 * *width, kLeast, reach)}))
    return std::nullopt;
  return edge;
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

}  // namespace

Eigen::Matrix<double, 2, 4> corners_by_edges(const GreyPicture& pixels,
                                             const Eigen::Matrix<double, 2, 4>& corners) {
  const Eigen::Vector2d middle = corners.rowwise().mean();
  const EdgePicture picture(pixels, corners);
  std::array<TagEdge, 4> edges;
  for (int i = 0; i < 4; ++i) {
    const auto edge = edge_between(picture, corners.col(i), corners.col((i + 1) % 4), middle);
    if (!edge) return corners;
    edges[i] = *edge;
  }
  TagCorners result;
  for (int i = 0; i < 4; ++i) {
    const auto corner = meeting(edges[(i + 3) % 4], edges[i]);
    if (!corner || !((*corner - corners.col(i)).norm() < kFurthest)) return corners;
    result.col(i) = *corner;
  }
  return result;
}

}  // namespace pliant
