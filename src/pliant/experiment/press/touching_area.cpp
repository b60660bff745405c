#include "pliant/experiment/press/touching_area.h"

#include <algorithm>
#include <vector>

#include <Eigen/Geometry>

namespace pliant {
namespace {

constexpr int kParts = 6;  // of each edge of a triangle

/// Shares of a triangle's corners at the middles of kParts^2 equal parts of it.
const std::vector<Eigen::Vector3d>& places_of_a_triangle() {
  static const std::vector<Eigen::Vector3d> places = [] {
    std::vector<Eigen::Vector3d> made;
    const auto add = [&](double i, double j) {
      made.emplace_back(1 - (i + j) / kParts, i / kParts, j / kParts);
    };
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; i + j < kParts; ++j) {
        add(i + 1 / 3.0, j + 1 / 3.0);
        if (i + j + 1 < kParts) add(i + 2 / 3.0, j + 2 / 3.0);
      }
    }
    return made;
  }();
  return places;
}

struct Share {
  double value = 0, slope = 0;
};

/// Falls from 1 at 0 to 0 at 1, with a continuous slope.
Share fading_share(double beyond) {
  if (beyond <= 0) return {1, 0};
  if (beyond >= 1) return {0, 0};
  return {1 - beyond * beyond * (3 - 2 * beyond), -6 * beyond * (1 - beyond)};
}

}  // namespace

SmoothedArea touching_area(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                           const ObstacleShape& indenter, const Pose& at,
                           const Eigen::Vector3d& direction, double contact, double fading) {
  SmoothedArea area;
  area.by_position = Eigen::Matrix3Xd::Zero(3, positions.cols());
  const std::vector<Eigen::Vector3d>& places = places_of_a_triangle();
  const double part = 1 / static_cast<double>(places.size());
  for (const auto& corners : triangles.colwise()) {
    Eigen::Matrix3d points;
    for (int i = 0; i < 3; ++i) points.col(i) = positions.col(corners(i));
    const auto gap_of = [&](const Eigen::Vector3d& point) {
      return distance_to(indenter, at.local(point)) - contact;
    };
    const double longest = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
    if (gap_of(points.col(0)) > fading + longest) continue;
    const Eigen::Vector3d twice =
        (points.col(1) - points.col(0)).cross(points.col(2) - points.col(0));
    const double size = twice.norm() / 2;
    const Eigen::Vector3d normal = twice.normalized();
    double share = 0;
    for (const Eigen::Vector3d& corner_shares : places) {
      const Eigen::Vector3d place = at.local(points * corner_shares);
      const SurfaceDistance surface = surface_distance(indenter, place);
      const Share counts = fading_share((surface.distance - contact) / fading);
      share += part * counts.value;
      if (counts.slope == 0) continue;
      const Eigen::Vector3d by_place =
          size * part * counts.slope / fading * (at.rotation * surface.normal);
      for (int i = 0; i < 3; ++i) area.by_position.col(corners(i)) += corner_shares(i) * by_place;
      area.by_travel -= by_place.dot(direction);
    }
    area.value += size * share;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d across = points.col((i + 2) % 3) - points.col((i + 1) % 3);
      area.by_position.col(corners(i)) += share / 2 * normal.cross(across);
    }
  }
  return area;
}

}  // namespace pliant
