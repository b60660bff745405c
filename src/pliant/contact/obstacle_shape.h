#pragma once

#include <variant>

#include <Eigen/Core>

namespace pliant {

/// What lies below a plane.
struct HalfSpace {
  Eigen::Vector3d point;   ///< of its surface, m
  Eigen::Vector3d normal;  ///< out of it, of unit length
};

struct Sphere {
  Eigen::Vector3d centre;  ///< m
  double radius = 0;       ///< m, > 0
};

/// All points nearer to a line than its radius.
struct Capsule {
  Eigen::Vector3d from, to;  ///< ends of the line, m; not one point
  double radius = 0;         ///< m, > 0
};

/// A box along the axes.
struct Box {
  Eigen::Vector3d centre;  ///< m
  Eigen::Vector3d half;    ///< half of its sides, m, > 0
};

/// A convex body.
using ObstacleShape = std::variant<HalfSpace, Sphere, Capsule, Box>;

/// Where a point is to the surface of a body.
struct SurfaceDistance {
  double distance = 0;        ///< m, negative inside
  Eigen::Vector3d normal;     ///< its gradient: out of the body, of unit length; continuous outside
  Eigen::Matrix3d curvature;  ///< its second derivatives, 1/m; positive semidefinite outside
};

SurfaceDistance surface_distance(const ObstacleShape& shape, const Eigen::Vector3d& point);

/// The distance alone.
double distance_to(const ObstacleShape& shape, const Eigen::Vector3d& point);

/// How much of a straight way a point goes before it is nearer to the body than `keep`; 1: all of
/// it. Never too much.
/// @param from  further from the body than `keep`
double free_share(const ObstacleShape& shape, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to, double keep);

}  // namespace pliant
