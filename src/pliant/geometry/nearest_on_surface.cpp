#include "pliant/geometry/nearest_on_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

using Corners = Eigen::Matrix3d;  // a column each

// Shares of the place of an edge, from corner i to corner j, that is nearest.
Eigen::Vector3d nearest_on_edge(const Corners& x, int i, int j, const Eigen::Vector3d& place) {
  const Eigen::Vector3d edge = x.col(j) - x.col(i);
  const double along = (place - x.col(i)).dot(edge) / edge.squaredNorm();
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();
  shares(j) = std::clamp(along, 0.0, 1.0);
  shares(i) = 1 - shares(j);
  return shares;
}

// Shares of the foot of the perpendicular; some are negative where it falls outside.
Eigen::Vector3d foot(const Corners& x, const Eigen::Vector3d& place) {
  Eigen::Matrix<double, 3, 2> edges;
  edges << x.col(1) - x.col(0), x.col(2) - x.col(0);
  const Eigen::Vector2d along =
      (edges.transpose() * edges).partialPivLu().solve(edges.transpose() * (place - x.col(0)));
  return {1 - along.sum(), along(0), along(1)};
}

Eigen::Vector3d nearest_on_triangle(const Corners& x, const Eigen::Vector3d& place) {
  const Eigen::Vector3d inside = foot(x, place);
  if (inside.minCoeff() >= 0) return inside;
  Eigen::Vector3d nearest = nearest_on_edge(x, 0, 1, place);
  for (const auto& other : {nearest_on_edge(x, 1, 2, place), nearest_on_edge(x, 2, 0, place)}) {
    if ((x * other - place).squaredNorm() < (x * nearest - place).squaredNorm()) nearest = other;
  }
  return nearest;
}

}  // namespace

SurfacePlace nearest_on_surface(const Eigen::Matrix3Xd& positions,
                                const Eigen::Matrix3Xi& triangles, const Eigen::Vector3d& place) {
  PLIANT_ASSERT(triangles.cols() > 0, "a surface has triangles");
  SurfacePlace nearest;
  nearest.distance = INFINITY;
  for (const auto& nodes : triangles.colwise()) {
    const Corners x = positions(Eigen::all, nodes);
    const Eigen::Vector3d shares = nearest_on_triangle(x, place);
    const double distance = (x * shares - place).norm();
    if (distance < nearest.distance) nearest = {nodes, shares, distance};
  }
  return nearest;
}

}  // namespace pliant
