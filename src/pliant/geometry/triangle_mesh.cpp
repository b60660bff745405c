#include "pliant/geometry/triangle_mesh.h"

#include <Eigen/LU>

namespace pliant {

double rest_area(const TriangleMesh& mesh, int triangle) {
  const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(triangle);
  Eigen::Matrix2d edges;
  edges << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  return edges.determinant() / 2;
}

double rest_area(const TriangleMesh& mesh) {
  double area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) area += rest_area(mesh, t);
  return area;
}

TriangleMesh flat_mesh(const Eigen::Matrix2Xd& vertices, const Eigen::Matrix3Xi& triangles) {
  TriangleMesh mesh;
  mesh.positions = Eigen::Matrix3Xd::Zero(3, vertices.cols());
  mesh.positions.topRows<2>() = vertices;
  mesh.triangles = triangles;
  mesh.rest_corners.resize(2, 3 * triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      mesh.rest_corners.col(3 * t + k) = vertices.col(triangles(k, t));
    }
  }
  return mesh;
}

}  // namespace pliant
