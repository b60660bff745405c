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

// Of two lines: where both are nearest to each other in between, or an end is nearest to the other.
double distance_of_lines(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  double least = std::min({distance_to_line(c, d, a), distance_to_line(c, d, b),
                           distance_to_line(a, b, c), distance_to_line(a, b, d)});
  const Eigen::Vector3d normal = (b - a).cross(d - c);
  const double area = normal.squaredNorm();
  if (area == 0) return least;  // they are parallel
  const double on_first = (c - a).cross(d - c).dot(normal) / area;
  const double on_second = (c - a).cross(b - a).dot(normal) / area;
  const bool between = on_first > 0 && on_first < 1 && on_second > 0 && on_second < 1;
  return between ? std::min(least, std::abs((c - a).dot(normal)) / std::sqrt(area)) : least;
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

double least(const HalfSpace& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::min(body.normal.dot(from - body.point), body.normal.dot(to - body.point));
}

double least(const Sphere& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return distance_to_line(from, to, body.centre) - body.radius;
}

double least(const Capsule& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return distance_of_lines(from, to, body.from, body.to) - body.radius;
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

}  // namespace

SurfaceDistance surface_distance(const ObstacleShape& shape, const Eigen::Vector3d& point) {
  return std::visit([&](const auto& body) { return distance(body, point); }, shape);
}

double distance_to(const ObstacleShape& shape, const Eigen::Vector3d& point) {
  return std::visit([&](const auto& body) { return only(body, point); }, shape);
}

double least_distance(const ObstacleShape& shape, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to) {
  return std::visit([&](const auto& body) { return least(body, from, to); }, shape);
}

}  // namespace pliant
