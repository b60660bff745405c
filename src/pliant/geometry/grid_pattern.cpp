#include "pliant/geometry/grid_pattern.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Coordinates in files are rounded: sides count as parallel or equal within this fraction.
constexpr double kTolerance = 1e-3;

// A triangle as half of a rectangle.
struct HalfRectangle {
  double side_u = 0, side_v = 0;
  bool rising = false;  // the diagonal runs from lower left to upper right
};

bool is_parallel_to_u(const Eigen::Vector2d& side) {
  return std::abs(side.y()) <= kTolerance * std::abs(side.x());
}

bool is_parallel_to_v(const Eigen::Vector2d& side) {
  return std::abs(side.x()) <= kTolerance * std::abs(side.y());
}

std::optional<HalfRectangle> half_rectangle(const Eigen::Matrix<double, 2, 3>& corners) {
  HalfRectangle half;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d side = corners.col((k + 1) % 3) - corners.col(k);
    if (is_parallel_to_u(side)) {
      half.side_u = std::abs(side.x());
    } else if (is_parallel_to_v(side)) {
      half.side_v = std::abs(side.y());
    } else {
      half.rising = side.x() * side.y() > 0;
    }
  }
  if (half.side_u == 0 || half.side_v == 0) return std::nullopt;
  return half;
}

bool nearly_equal(double a, double b) { return std::abs(a - b) <= kTolerance * std::abs(b); }

// Whether a hinge lies between two rectangles, and not on the diagonal of one.
bool is_between_rectangles(const Hinge& hinge) {
  return is_parallel_to_u(hinge.rest_edge) || is_parallel_to_v(hinge.rest_edge);
}

// How the diagonals go on from rectangle to rectangle.
std::optional<Diagonals> diagonals_of(const std::vector<HalfRectangle>& halves,
                                      const std::vector<Hinge>& hinges) {
  const bool rising = halves.front().rising;
  const auto runs_as_first = [&](const HalfRectangle& h) { return h.rising == rising; };
  if (std::all_of(halves.begin(), halves.end(), runs_as_first)) {
    return rising ? Diagonals::rising : Diagonals::falling;
  }
  const auto alternates = [&](const Hinge& hinge) {
    return !is_between_rectangles(hinge) ||
           halves[hinge.triangles[0]].rising != halves[hinge.triangles[1]].rising;
  };
  if (std::all_of(hinges.begin(), hinges.end(), alternates)) return Diagonals::alternating;
  return std::nullopt;
}

}  // namespace

bool is_cut_from_rectangles(const TriangleMesh& mesh) {
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (!half_rectangle(mesh.rest_triangle(t))) return false;
  }
  return true;
}

std::optional<GridPattern> grid_pattern(const TriangleMesh& mesh,
                                        const std::vector<Hinge>& hinges) {
  std::vector<HalfRectangle> halves;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto half = half_rectangle(mesh.rest_triangle(t));
    if (!half) return std::nullopt;
    halves.push_back(*half);
    const HalfRectangle& first = halves.front();
    if (!nearly_equal(half->side_u, first.side_u) || !nearly_equal(half->side_v, first.side_v)) {
      return std::nullopt;
    }
  }
  if (halves.empty()) return std::nullopt;
  const auto diagonals = diagonals_of(halves, hinges);
  if (!diagonals) return std::nullopt;
  return GridPattern{halves.front().side_u, halves.front().side_v, *diagonals};
}

}  // namespace pliant
