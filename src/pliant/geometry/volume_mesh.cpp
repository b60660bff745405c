#include "pliant/geometry/volume_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {
namespace {

// Sides of elements, seen from outside counter-clockwise; the last number of a triangle is -1.
constexpr int kTetrahedronSides[4][4] = {
    {0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}};
constexpr int kHexahedronSides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

struct Side {
  std::array<int, 4> sorted;  // which sides of neighbours have in common
  std::array<int, 4> nodes;
  int element = 0;
};

std::vector<Side> all_sides(const VolumeMesh& mesh) {
  std::vector<Side> sides;
  const auto add = [&](const auto& nodes, const int(&side)[4], int element) {
    std::array<int, 4> own{};
    for (size_t i = 0; i < 4; ++i) own[i] = side[i] < 0 ? -1 : nodes(side[i]);
    sides.push_back({own, own, element});
    std::ranges::sort(sides.back().sorted);
  };
  for (int e = 0; e < mesh.tetrahedron_count(); ++e) {
    for (const auto& side : kTetrahedronSides) add(mesh.tetrahedra.col(e), side, e);
  }
  for (int e = 0; e < mesh.hexahedron_count(); ++e) {
    for (const auto& side : kHexahedronSides) {
      add(mesh.hexahedra.col(e), side, mesh.tetrahedron_count() + e);
    }
  }
  return sides;
}

double tetrahedron_volume_of(const VolumeMesh& mesh, int tetrahedron) {
  const Eigen::Matrix<double, 3, 4> x =
      mesh.positions(Eigen::all, mesh.tetrahedra.col(tetrahedron));
  const Eigen::Matrix3d edges = x.rightCols<3>().colwise() - x.col(0);
  return edges.determinant() / 6;
}

}  // namespace

std::vector<int> VolumeMesh::nodes_of(int element) const {
  if (element < tetrahedron_count()) {
    const auto nodes = tetrahedra.col(element);
    return {nodes.begin(), nodes.end()};
  }
  const auto nodes = hexahedra.col(element - tetrahedron_count());
  return {nodes.begin(), nodes.end()};
}

Eigen::VectorXd element_volumes(const VolumeMesh& mesh) {
  Eigen::VectorXd volumes(mesh.element_count());
  for (int e = 0; e < mesh.tetrahedron_count(); ++e) volumes(e) = tetrahedron_volume_of(mesh, e);
  for (int e = 0; e < mesh.hexahedron_count(); ++e) {
    const auto sizes = hexahedron_sizes(mesh.positions(Eigen::all, mesh.hexahedra.col(e)));
    volumes(mesh.tetrahedron_count() + e) = sizes.sum();
  }
  return volumes;
}

Eigen::VectorXd node_volumes(const VolumeMesh& mesh) {
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(mesh.node_count());
  for (int e = 0; e < mesh.tetrahedron_count(); ++e) {
    const double share = tetrahedron_volume_of(mesh, e) / 4;
    for (const int node : mesh.tetrahedra.col(e)) volumes(node) += share;
  }
  for (int e = 0; e < mesh.hexahedron_count(); ++e) {
    const auto nodes = mesh.hexahedra.col(e);
    const auto sizes = hexahedron_sizes(mesh.positions(Eigen::all, nodes));
    for (int p = 0; p < 8; ++p) {
      const auto shares = hexahedron_shares()[static_cast<size_t>(p)];
      for (int i = 0; i < 8; ++i) volumes(nodes(i)) += sizes(p) * shares(i);
    }
  }
  return volumes;
}

BoundarySurface boundary_surface(const VolumeMesh& mesh) {
  std::vector<Side> sides = all_sides(mesh);
  std::ranges::stable_sort(sides, {}, &Side::sorted);
  std::vector<Side> outer;
  for (size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].sorted == sides[begin].sorted) ++end;
    if (end == begin + 1) outer.push_back(sides[begin]);
  }
  std::ranges::stable_sort(outer, {}, &Side::element);
  BoundarySurface surface;
  std::vector<int> corners;
  for (const Side& side : outer) {
    const auto& n = side.nodes;
    corners.insert(corners.end(), {n[0], n[1], n[2]});
    surface.elements.push_back(side.element);
    if (n[3] < 0) continue;
    corners.insert(corners.end(), {n[0], n[2], n[3]});
    surface.elements.push_back(side.element);
  }
  surface.triangles =
      Eigen::Map<const Eigen::Matrix3Xi>(corners.data(), 3, std::ssize(surface.elements));
  return surface;
}

Eigen::VectorXd node_areas(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(positions.cols());
  for (const auto& nodes : triangles.colwise()) {
    const Eigen::Vector3d a = positions.col(nodes(1)) - positions.col(nodes(0));
    const Eigen::Vector3d b = positions.col(nodes(2)) - positions.col(nodes(0));
    const double third = a.cross(b).norm() / 6;
    for (const int node : nodes) areas(node) += third;
  }
  return areas;
}

double extent_of(const VolumeMesh& mesh) {
  return (mesh.positions.rowwise().maxCoeff() - mesh.positions.rowwise().minCoeff()).norm();
}

double mean_surface_edge(const VolumeMesh& mesh) {
  double sum = 0;
  const Eigen::Matrix3Xi triangles = boundary_surface(mesh).triangles;
  for (const auto& t : triangles.colwise()) {
    for (int i = 0; i < 3; ++i) {
      sum += (mesh.positions.col(t(i)) - mesh.positions.col(t((i + 1) % 3))).norm();
    }
  }
  return sum / static_cast<double>(triangles.size());
}

std::vector<int> nodes_at(const VolumeMesh& mesh, int axis, double value) {
  constexpr double kRounding = 1e-9;
  const double tolerance = kRounding * mesh.positions.cwiseAbs().maxCoeff();
  std::vector<int> nodes;
  for (int i = 0; i < mesh.node_count(); ++i) {
    if (std::abs(mesh.positions(axis, i) - value) <= tolerance) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace pliant
