#include "pliant/geometry/convex_hull.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

using Point = Eigen::Vector2d;

/// Positive where a, b, c turn left.
double turn(const Point& a, const Point& b, const Point& c) {
  const Point in = b - a, out = c - a;
  return in.x() * out.y() - in.y() * out.x();
}

/// Adds the side of the hull that the points, in the order of a sweep, have on their right; its
/// last corner is left to the sweep back.
template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<Point>& hull) {
  const std::size_t begin = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), *first) <= 0) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();
}

double distance_from_segment(const Point& a, const Point& b, const Point& point) {
  const Point along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - (a + t * along)).norm();
}

}  // namespace

Eigen::Matrix2Xd convex_hull(const Eigen::Matrix2Xd& points) {
  PLIANT_ASSERT(points.cols() > 0, "a hull of points");
  std::vector<Point> sorted;
  for (const auto& point : points.colwise()) sorted.emplace_back(point);
  const auto before = [](const Point& a, const Point& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(sorted.begin(), sorted.end(), before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() == 1) return sorted.front();
  // Andrew's monotone chains, there and back.
  std::vector<Point> hull;
  add_chain(sorted.begin(), sorted.end(), hull);
  add_chain(sorted.rbegin(), sorted.rend(), hull);
  Eigen::Matrix2Xd corners(2, hull.size());
  for (Eigen::Index i = 0; i < corners.cols(); ++i) corners.col(i) = hull[i];
  return corners;
}

double distance_from_convex(const Eigen::Matrix2Xd& corners, const Eigen::Vector2d& point) {
  bool inside = corners.cols() > 2;
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    const Point a = corners.col(i), b = corners.col((i + 1) % corners.cols());
    inside = inside && turn(a, b, point) >= 0;
    nearest = std::min(nearest, distance_from_segment(a, b, point));
  }
  return inside ? 0 : nearest;
}

}  // namespace pliant
