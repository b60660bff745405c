#include "pliant/scene/obstacle_depth.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace pliant {
namespace {

using Triangle = Eigen::Matrix3d;  // a column a corner

struct Line {
  Eigen::Vector3d from, to;

  Eigen::Vector3d way() const { return to - from; }
};

Line side_of(const Triangle& corners, int side) {
  return {corners.col(side), corners.col((side + 1) % 3)};
}

Eigen::Vector3d normal_of(const Triangle& corners) {  // not of unit length
  return side_of(corners, 0).way().cross(side_of(corners, 1).way());
}

// Whether the foot of its perpendicular on the plane of a triangle lies within that.
bool is_over(const Triangle& corners, const Eigen::Vector3d& place) {
  const Eigen::Vector3d normal = normal_of(corners);
  for (int k = 0; k < 3; ++k) {
    const Line side = side_of(corners, k);
    if (side.way().cross(place - side.from).dot(normal) <= 0) return false;
  }
  return true;
}

double distance(const Line& line, const Eigen::Vector3d& place) {
  const double along = line.way().dot(place - line.from) / line.way().squaredNorm();
  return (line.from + std::clamp(along, 0.0, 1.0) * line.way() - place).norm();
}

// An end is nearest to the other line, or the common perpendicular is shortest.
double distance(const Line& one, const Line& other) {
  constexpr double kParallel = 1e-20;  // square of the sine
  const double of_ends = std::min({distance(one, other.from), distance(one, other.to),
                                   distance(other, one.from), distance(other, one.to)});
  const Eigen::Vector3d apart = other.from - one.from, across = one.way().cross(other.way());
  const double square = across.squaredNorm();
  if (square <= kParallel * one.way().squaredNorm() * other.way().squaredNorm()) return of_ends;
  const double on_one = apart.cross(other.way()).dot(across) / square,
               on_other = apart.cross(one.way()).dot(across) / square;
  const bool meets_both = std::min(on_one, on_other) >= 0 && std::max(on_one, on_other) <= 1;
  return meets_both ? std::min(of_ends, std::abs(apart.dot(across)) / std::sqrt(square)) : of_ends;
}

double distance(const Triangle& corners, const Eigen::Vector3d& place) {
  if (is_over(corners, place)) {
    return std::abs(normal_of(corners).normalized().dot(place - corners.col(0)));
  }
  double least = INFINITY;
  for (int k = 0; k < 3; ++k) least = std::min(least, distance(side_of(corners, k), place));
  return least;
}

bool pierces(const Line& line, const Triangle& corners) {
  const Eigen::Vector3d normal = normal_of(corners);
  const double from = normal.dot(line.from - corners.col(0)),
               to = normal.dot(line.to - corners.col(0));
  return from * to < 0 && is_over(corners, line.from + from / (from - to) * line.way());
}

double distance(const Triangle& corners, const Line& line) {
  if (pierces(line, corners)) return 0;
  double least = std::min(distance(corners, line.from), distance(corners, line.to));
  for (int k = 0; k < 3; ++k) least = std::min(least, distance(side_of(corners, k), line));
  return least;
}

double depth(const HalfSpace& body, const Eigen::Vector3d& place) {
  return body.normal.dot(body.point - place);
}

double depth(const Sphere& body, const Eigen::Vector3d& place) {
  return body.radius - (place - body.centre).norm();
}

double depth(const Capsule& body, const Eigen::Vector3d& place) {
  return body.radius - distance(Line{body.from, body.to}, place);
}

double depth(const Box& body, const Eigen::Vector3d& place) {
  return (body.half - (place - body.centre).cwiseAbs()).minCoeff();
}

double depth(const HalfSpace& body, const Triangle& corners) {
  return (body.normal.transpose() * (-(corners.colwise() - body.point))).maxCoeff();
}

double depth(const Sphere& body, const Triangle& corners) {
  return body.radius - distance(corners, body.centre);
}

double depth(const Capsule& body, const Triangle& corners) {
  return body.radius - distance(corners, Line{body.from, body.to});
}

// All that is deeper than d is a box whose sides lie d further in. A triangle misses a box only
// where an axis parts them: a normal of either, or one across an edge of each. Each axis gives the
// largest d with which it does not.
double depth(const Box& body, const Triangle& corners) {
  const Triangle local = corners.colwise() - body.centre;
  double deepest = body.half.minCoeff();
  const auto look_along = [&](const Eigen::Vector3d& axis) {
    if (axis.isZero(0)) return;
    const Eigen::RowVector3d places = axis.transpose() * local;
    const double nearest = std::max(places.minCoeff(), -places.maxCoeff());
    const double reach = body.half.dot(axis.cwiseAbs());
    deepest = std::min(deepest, (reach - nearest) / axis.lpNorm<1>());
  };
  look_along(normal_of(local));
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d edge = Eigen::Vector3d::Unit(k);
    look_along(edge);
    for (int side = 0; side < 3; ++side) look_along(side_of(local, side).way().cross(edge));
  }
  return deepest;
}

}  // namespace

double depth_of_place(const ObstacleShape& shape, const Eigen::Vector3d& place) {
  return std::visit([&](const auto& body) { return depth(body, place); }, shape);
}

double depth_of_triangle(const ObstacleShape& shape, const Eigen::Matrix3d& corners) {
  return std::visit([&](const auto& body) { return depth(body, corners); }, shape);
}

}  // namespace pliant
