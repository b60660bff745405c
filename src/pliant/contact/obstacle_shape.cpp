#include "pliant/contact/obstacle_shape.h"

#include <algorithm>

namespace pliant {
namespace {

// Share of the way along a line at which it is nearest to a point.
double nearest_share(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = to - from;
  const double length = way.squaredNorm();
  return length > 0 ? std::clamp(way.dot(point - from) / length, 0.0, 1.0) : 0;
}

double distance_to_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                        const Eigen::Vector3d& point) {
  return (point - from - nearest_share(from, to, point) * (to - from)).norm();
}

// Distance from a point of a round body's core; `along` is the direction of a line, or zero.
SurfaceDistance round(const Eigen::Vector3d& away, const Eigen::Vector3d& along, double radius) {
  const double length = away.norm();
  const Eigen::Vector3d normal =
      length > 0 ? (away / length).eval() : Eigen::Vector3d::UnitZ().eval();
  const Eigen::Matrix3d across =
      Eigen::Matrix3d::Identity() - normal * normal.transpose() - along * along.transpose();
  return {length - radius, normal, length > 0 ? (across / length).eval() : across};
}

SurfaceDistance distance(const HalfSpace& body, const Eigen::Vector3d& point) {
  return {body.normal.dot(point - body.point), body.normal, Eigen::Matrix3d::Zero()};
}

SurfaceDistance distance(const Sphere& body, const Eigen::Vector3d& point) {
  return round(point - body.centre, Eigen::Vector3d::Zero(), body.radius);
}

SurfaceDistance distance(const Capsule& body, const Eigen::Vector3d& point) {
  const double share = nearest_share(body.from, body.to, point);
  const Eigen::Vector3d core = body.from + share * (body.to - body.from);
  const bool beside = share > 0 && share < 1;
  const Eigen::Vector3d along =
      beside ? (body.to - body.from).normalized() : Eigen::Vector3d::Zero().eval();
  return round(point - core, along, body.radius);
}

// Where a point is beyond the faces of a box, along each axis; negative between two.
Eigen::Vector3d beyond_faces(const Box& body, const Eigen::Vector3d& point) {
  return (point - body.centre).cwiseAbs() - body.half;
}

SurfaceDistance distance(const Box& body, const Eigen::Vector3d& point) {
  const Eigen::Vector3d beyond = beyond_faces(body, point);
  const Eigen::Vector3d sides =
      (point - body.centre).unaryExpr([](double x) { return x < 0 ? -1.0 : 1.0; });
  const Eigen::Vector3d out = beyond.cwiseMax(0);
  const double length = out.norm();
  if (length == 0) {
    Eigen::Index face = 0;
    const double depth = beyond.maxCoeff(&face);
    return {depth, sides(face) * Eigen::Vector3d::Unit(face), Eigen::Matrix3d::Zero()};
  }
  const Eigen::Vector3d normal = out.cwiseProduct(sides) / length;
  const Eigen::Vector3d reached = (out.array() > 0).cast<double>();
  const Eigen::Matrix3d curvature =
      (Eigen::Matrix3d(reached.asDiagonal()) - normal * normal.transpose()) / length;
  return {length, normal, curvature};
}

double only(const HalfSpace& body, const Eigen::Vector3d& point) {
  return body.normal.dot(point - body.point);
}

double only(const Sphere& body, const Eigen::Vector3d& point) {
  return (point - body.centre).norm() - body.radius;
}

double only(const Capsule& body, const Eigen::Vector3d& point) {
  return distance_to_line(body.from, body.to, point) - body.radius;
}

double only(const Box& body, const Eigen::Vector3d& point) {
  const Eigen::Vector3d beyond = beyond_faces(body, point);
  return beyond.maxCoeff() > 0 ? beyond.cwiseMax(0).norm() : beyond.maxCoeff();
}

}  // namespace

SurfaceDistance surface_distance(const ObstacleShape& shape, const Eigen::Vector3d& point) {
  return std::visit([&](const auto& body) { return distance(body, point); }, shape);
}

double distance_to(const ObstacleShape& shape, const Eigen::Vector3d& point) {
  return std::visit([&](const auto& body) { return only(body, point); }, shape);
}

// The distance from a convex body is a convex function on a line: Newton's method comes to where it
// falls below `keep` from before, and once it grows it goes on growing.
double free_share(const ObstacleShape& shape, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to, double keep) {
  constexpr double kNear = 1e-3;
  constexpr int kSteps = 50;
  const Eigen::Vector3d way = to - from;
  double share = 0;
  for (int i = 0; i < kSteps; ++i) {
    const SurfaceDistance surface = surface_distance(shape, from + share * way);
    const double room = surface.distance - keep, slope = surface.normal.dot(way);
    if (slope >= 0) return 1;
    if (room <= kNear * keep) return share;
    share -= room / slope;
    if (share >= 1) return 1;
  }
  return share;
}

}  // namespace pliant
