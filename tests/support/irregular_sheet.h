#pragma once

#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "pliant/base/random.h"
#include "pliant/geometry/hinges.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant::test {

inline bool is_in_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& c, const Eigen::Vector2d& p) {
  Eigen::Matrix3d m;
  const Eigen::Vector2d corners[3] = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d d = corners[i] - p;
    m.row(i) << d.x(), d.y(), d.squaredNorm();
  }
  return m.determinant() > 1e-12 * std::pow((b - a).norm(), 4);
}

/// Turns edges until the triangles are those of Delaunay (Lawson's algorithm, in sweeps).
inline void make_delaunay(const Eigen::Matrix2Xd& vertices, Eigen::Matrix3Xi& triangles) {
  for (bool turned = true; turned;) {
    turned = false;
    std::vector<bool> touched(triangles.cols(), false);
    for (const Hinge& hinge : find_hinges(flat_mesh(vertices, triangles))) {
      const auto [a, b, c, d] = hinge.vertices;
      const auto [first, second] = hinge.triangles;
      if (touched[first] || touched[second]) continue;
      if (!is_in_circle(vertices.col(a), vertices.col(b), vertices.col(c), vertices.col(d))) {
        continue;
      }
      triangles.col(first) << d, c, a;
      triangles.col(second) << c, d, b;
      touched[first] = touched[second] = turned = true;
    }
  }
}

/// Moves the vertices inside to the middle of the triangles around them.
inline void smooth(Eigen::Matrix2Xd& vertices, const Eigen::Matrix3Xi& triangles,
                   const std::vector<bool>& is_inside) {
  const TriangleMesh mesh = flat_mesh(vertices, triangles);
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, vertices.cols());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const double area = rest_area(mesh, t);
    const Eigen::Vector2d middle = mesh.rest_triangle(t).rowwise().mean();
    for (int k = 0; k < 3; ++k) {
      sums.col(triangles(k, t)) += area * Eigen::Vector3d(middle.x(), middle.y(), 1);
    }
  }
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    if (is_inside[i]) vertices.col(i) = sums.col(i).head<2>() / sums(2, i);
  }
}

/// A square of well-shaped irregular triangles: a grid that was shaken again and again, each time
/// triangulated anew and smoothed, until nothing of its directions is left.
/// @param cells  of the grid along each side, `edge` (m) wide
inline TriangleMesh irregular_sheet(int cells, double edge, std::uint64_t seed) {
  const TriangleMesh grid = regular_grid(cells * edge, cells * edge, cells + 1, cells + 1);
  Eigen::Matrix2Xd vertices = grid.positions.topRows<2>();
  Eigen::Matrix3Xi triangles = grid.triangles;
  std::vector<bool> is_inside(vertices.cols());
  for (int i = 0; i < vertices.cols(); ++i) {
    const int u = i % (cells + 1), v = i / (cells + 1);
    is_inside[i] = u > 0 && u < cells && v > 0 && v < cells;
  }
  RandomStream random(seed);
  for (int round = 0; round < 12; ++round) {
    // Small enough steps that no triangle turns over; the last rounds only smooth.
    const double step = round < 8 ? 0.2 * edge : 0;
    for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
      if (is_inside[i]) {
        vertices.col(i) += step * Eigen::Vector2d(random.uniform() - 0.5, random.uniform() - 0.5);
      }
    }
    make_delaunay(vertices, triangles);
    smooth(vertices, triangles, is_inside);
    make_delaunay(vertices, triangles);
  }
  return flat_mesh(vertices, triangles);
}

}  // namespace pliant::test
