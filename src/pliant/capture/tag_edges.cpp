#include "pliant/capture/tag_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace pliant {
namespace {

using TagCorners = Eigen::Matrix<double, 2, 4>;

// Cells of a tag's side; the outermost are black, and beside them the paper is white.
constexpr double kCells = 8;
// Places nearer than this share of the side to a corner see the other edge through the blur.
constexpr double kLeftOut = 0.08;
constexpr int kFewestPlaces = 6;
// With fewer, a parabola follows noise rather than the lens.
constexpr int kFewestForParabola = 40;
// In smaller cells the blur of both of their edges is one.
constexpr double kLeastDepth = 2;  // pixels
constexpr double kFurthest = 2.5;  // pixels that a corner may move

// One edge: from a corner along `along` (unit) for `length` pixels; it lies `offset(t)` pixels
// beside that line, towards `across`, at t from 0 to 1.
struct TagEdge {
  Eigen::Vector2d from, along, across;
  double length = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // of 1, t, t^2

  Eigen::Vector2d at(double t) const {
    return from + t * length * along + (offset(0) + t * (offset(1) + t * offset(2))) * across;
  }
  Eigen::Vector2d slope(double t) const {
    return length * along + (offset(1) + 2 * t * offset(2)) * across;
  }
};

// Where the brightness changes across an edge: the middle of its gradient within `reach`, about
// which the window is laid again.
std::optional<double> edge_across(const SplinePicture& picture, const Eigen::Vector2d& place,
                                  const Eigen::Vector2d& across, double reach) {
  constexpr double kStep = 0.25;
  const int steps = static_cast<int>(reach / kStep);
  double middle = 0;
  for (int round = 0; round < 4; ++round) {
    double sum = 0, moment = 0;
    for (int i = -steps; i <= steps; ++i) {
      const double s = middle + i * kStep;
      const Eigen::Vector2d at = place + s * across;
      if (!picture.contains(at)) return std::nullopt;
      const double change = picture.sample(at).gradient.cast<double>().dot(across);
      sum += change;
      moment += change * s;
    }
    if (!(sum > 0)) return std::nullopt;  // it gets brighter outwards
    const double next = moment / sum;
    if (std::abs(next) > reach) return std::nullopt;
    if (std::abs(next - middle) < 1e-3) return next;
    middle = next;
  }
  return middle;
}

bool fit_edge(TagEdge& edge, const std::vector<Eigen::Vector2d>& places) {
  const auto count = std::ssize(places);
  if (count < kFewestPlaces) return false;
  const int terms = count < kFewestForParabola ? 2 : 3;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count), offsets(count);
  Eigen::MatrixXd powers(count, terms);
  for (int i = 0; i < count; ++i) {
    offsets(i) = places[i].y();
    for (int k = 0; k < terms; ++k) powers(i, k) = std::pow(places[i].x(), k);
  }
  // Twice, the second time without places that are off: a scratch, a finger.
  for (int round = 0; round < 2; ++round) {
    edge.offset.head(terms) =
        (weights.asDiagonal() * powers).colPivHouseholderQr().solve(weights.cwiseProduct(offsets));
    const Eigen::ArrayXd missed = (powers * edge.offset.head(terms) - offsets).array().abs();
    std::vector<double> sorted(missed.begin(), missed.end());
    std::ranges::nth_element(sorted, sorted.begin() + count / 2);
    const double limit = std::max(0.05, 4 * sorted[count / 2]);
    weights = (missed < limit).cast<double>();
    if (weights.sum() < kFewestPlaces) return false;
  }
  return true;
}

std::optional<TagEdge> edge_between(const SplinePicture& picture, const Eigen::Vector2d& from,
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
  const double reach = std::clamp(0.5 * depth, 1.0, 3.0);
  const int count = static_cast<int>(edge.length * (1 - 2 * kLeftOut));
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i <= count; ++i) {
    const double t = kLeftOut + (1 - 2 * kLeftOut) * i / std::max(count, 1);
    const auto offset = edge_across(picture, edge.at(t), edge.across, reach);
    if (offset) places.emplace_back(t, *offset);
  }
  if (!fit_edge(edge, places)) return std::nullopt;
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

Eigen::Matrix<double, 2, 4> corners_by_edges(const SplinePicture& picture,
                                             const Eigen::Matrix<double, 2, 4>& corners) {
  const Eigen::Vector2d middle = corners.rowwise().mean();
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
