#include "pliant/geometry/crossings.h"

#ifdef PLIANT_HAS_CGAL

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

namespace pliant {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<Point, 3>;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

/// Whether the inside of a segment meets the inside of a triangle at one point.
bool pierces(const Point& from, const Point& to, const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  if (CGAL::orientation(a, b, c, from) * CGAL::orientation(a, b, c, to) >= 0) return false;
  const CGAL::Orientation side = CGAL::orientation(from, to, a, b);
  return side != CGAL::COPLANAR && CGAL::orientation(from, to, b, c) == side &&
         CGAL::orientation(from, to, c, a) == side;
}

bool side_pierces(const Corners& sides, const Corners& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (pierces(sides[k], sides[(k + 1) % 3], triangle)) return true;
  }
  return false;
}

std::vector<Corners> corners_of(const Eigen::Matrix3Xd& positions,
                                const Eigen::Matrix3Xi& triangles) {
  std::vector<Corners> all;
  for (const auto& triangle : triangles.colwise()) {
    const auto point = [&](int k) {
      const auto position = positions.col(triangle[k]);
      return Point(position.x(), position.y(), position.z());
    };
    all.push_back({point(0), point(1), point(2)});
  }
  return all;
}

std::vector<Box> boxes_of(const std::vector<Corners>& corners) {
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    CGAL::Bbox_3 box;
    for (const Point& corner : corners[t]) box += corner.bbox();
    boxes.emplace_back(box, static_cast<int>(t));
  }
  return boxes;
}

bool cross(const Corners& one, const Corners& other) {
  return side_pierces(one, other) || side_pierces(other, one);
}

}  // namespace

std::optional<std::vector<std::array<int, 2>>> crossing_triangles(
    const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  const std::vector<Corners> corners = corners_of(positions, triangles);
  std::vector<Box> boxes = boxes_of(corners);
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [first, second] = std::minmax({a.info(), b.info()});
    if (cross(corners[static_cast<std::size_t>(first)],
              corners[static_cast<std::size_t>(second)])) {
      pairs.push_back({first, second});
    }
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<std::vector<std::array<int, 2>>> crossing_triangles(const Eigen::Matrix3Xd& positions,
                                                                  const Eigen::Matrix3Xi& one,
                                                                  const Eigen::Matrix3Xi& other) {
  const std::vector<Corners> ours = corners_of(positions, one),
                             theirs = corners_of(positions, other);
  std::vector<Box> our_boxes = boxes_of(ours), their_boxes = boxes_of(theirs);
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_intersection_d(our_boxes.begin(), our_boxes.end(), their_boxes.begin(),
                           their_boxes.end(), [&](const Box& a, const Box& b) {
                             if (cross(ours[static_cast<std::size_t>(a.info())],
                                       theirs[static_cast<std::size_t>(b.info())])) {
                               pairs.push_back({a.info(), b.info()});
                             }
                           });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pliant

#else

namespace pliant {

std::optional<std::vector<std::array<int, 2>>> crossing_triangles(const Eigen::Matrix3Xd&,
                                                                  const Eigen::Matrix3Xi&) {
  return std::nullopt;
}

std::optional<std::vector<std::array<int, 2>>> crossing_triangles(const Eigen::Matrix3Xd&,
                                                                  const Eigen::Matrix3Xi&,
                                                                  const Eigen::Matrix3Xi&) {
  return std::nullopt;
}

}  // namespace pliant

#endif
