#include "pliant/geometry/rest_search.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "pliant/base/assert.h"
#include "pliant/geometry/convex_hull.h"

namespace pliant {
namespace {

/// A point on a side belongs to the triangle despite rounding.
constexpr double kOnSide = 1e-9;

Eigen::Vector3d barycentric(const Eigen::Matrix<double, 2, 3>& corners,
                            const Eigen::Vector2d& point) {
  Eigen::Matrix2d edges;
  edges << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  const Eigen::Vector2d weights = edges.inverse() * (point - corners.col(0));
  return {1 - weights.sum(), weights.x(), weights.y()};
}

}  // namespace

RestSearch::RestSearch(const TriangleMesh& mesh) : mesh_(&mesh) {
  PLIANT_ASSERT(mesh.triangle_count() > 0, "a mesh with triangles");
  low_ = mesh.rest_corners.rowwise().minCoeff();
  const Eigen::Vector2d size = mesh.rest_corners.rowwise().maxCoeff() - low_;
  // About one triangle a cell.
  cell_size_ = std::sqrt(size.prod() / mesh.triangle_count());
  cells_ = (size / cell_size_).array().floor().cast<int>() + 1;
  triangles_.resize(static_cast<std::size_t>(cells_.prod()));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(t);
    const Eigen::Array2i first = cell_of(corners.rowwise().minCoeff());
    const Eigen::Array2i last = cell_of(corners.rowwise().maxCoeff());
    for (int row = first.y(); row <= last.y(); ++row) {
      for (int column = first.x(); column <= last.x(); ++column) {
        triangles_[static_cast<std::size_t>(row * cells_.x() + column)].push_back(t);
      }
    }
  }
}

Eigen::Array2i RestSearch::cell_of(const Eigen::Vector2d& point) const {
  const Eigen::Array2d cell = ((point - low_) / cell_size_).array().floor();
  return cell.max(0).min(cells_.cast<double>() - 1).cast<int>();
}

const std::vector<int>& RestSearch::triangles_in(const Eigen::Array2i& cell) const {
  return triangles_[static_cast<std::size_t>(cell.y() * cells_.x() + cell.x())];
}

RestPoint RestSearch::find(const Eigen::Vector2d& point) const {
  for (const int t : triangles_in(cell_of(point))) {
    const Eigen::Vector3d weights = barycentric(mesh_->rest_triangle(t), point);
    if (weights.minCoeff() >= -kOnSide) return {t, weights, 0};
  }
  const int t = nearest_triangle(point);
  const Eigen::Matrix<double, 2, 3> corners = mesh_->rest_triangle(t);
  return {t, barycentric(corners, point), distance_from_convex(corners, point)};
}

// Few points are outside, so that looking at every triangle does.
int RestSearch::nearest_triangle(const Eigen::Vector2d& point) const {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < mesh_->triangle_count(); ++t) {
    const double distance = distance_from_convex(mesh_->rest_triangle(t), point);
    if (distance >= least) continue;
    least = distance;
    nearest = t;
  }
  return nearest;
}

Eigen::Matrix3Xd interpolated(const TriangleMesh& mesh, const std::vector<RestPoint>& points,
                              const Eigen::Matrix3Xd& values) {
  PLIANT_ASSERT(values.cols() == mesh.vertex_count(), "a value for each vertex");
  Eigen::Matrix3Xd result(3, points.size());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const RestPoint& point = points[i];
    const Eigen::Vector3i corners = mesh.triangles.col(point.triangle);
    result.col(i) = values(Eigen::all, corners) * point.weights;
  }
  return result;
}

}  // namespace pliant
