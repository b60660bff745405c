#include "pliant/geometry/plane_cut.h"

#include <array>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {
namespace {

using Triangle = std::array<int, 3>;

/// Cuts one part of a mesh, whose new vertices are its own.
class PartCut {
 public:
  PartCut(const Eigen::Matrix3Xd& positions, const Plane& plane, PlaneCut& cut,
          std::vector<Triangle>& triangles)
      : positions_(positions), plane_(plane), cut_(cut), triangles_(triangles) {}

  /// Keeps what lies behind the plane of a triangle.
  void clip(const Eigen::Vector3i& corners) {
    std::vector<int> left;
    for (int i = 0; i < 3; ++i) {
      const int here = corners(i), next = corners((i + 1) % 3);
      if (is_left(here)) left.push_back(vertex(here, here));
      if (is_left(here) != is_left(next)) left.push_back(crossing(here, next));
    }
    for (std::size_t k = 2; k < left.size(); ++k) add(left[0], left[k - 1], left[k]);
  }

  /// The section of a tetrahedron.
  void section(const Eigen::Vector4i& corners) {
    std::vector<int> behind, before;
    for (const int corner : corners) (is_left(corner) ? behind : before).push_back(corner);
    if (behind.empty() || before.empty()) return;
    if (behind.size() == 2) {
      const int a = crossing(behind[0], before[0]), b = crossing(behind[0], before[1]),
                c = crossing(behind[1], before[1]), d = crossing(behind[1], before[0]);
      add_facing(a, b, c);
      add_facing(a, c, d);
      return;
    }
    const bool single_behind = behind.size() == 1;
    const int tip = single_behind ? behind.front() : before.front();
    const std::vector<int>& base = single_behind ? before : behind;
    add_facing(crossing(tip, base[0]), crossing(tip, base[1]), crossing(tip, base[2]));
  }

 private:
  double distance(int point) const { return plane_.distance(positions_.col(point)); }
  bool is_left(int point) const { return distance(point) <= 0; }

  int vertex(int from, int to, double share = 0) {
    const auto next = static_cast<int>(cut_.vertices.size());
    const auto [found, added] = known_.try_emplace({from, to}, next);
    if (added) cut_.vertices.push_back({from, to, share});
    return found->second;
  }

  int crossing(int one, int other) {
    const auto [from, to] = std::minmax(one, other);
    return vertex(from, to, distance(from) / (distance(from) - distance(to)));
  }

  Eigen::Vector3d place(int v) const {
    const PlaneCut::Vertex& own = cut_.vertices[static_cast<std::size_t>(v)];
    return (1 - own.share) * positions_.col(own.from) + own.share * positions_.col(own.to);
  }

  void add(int a, int b, int c) { triangles_.push_back({a, b, c}); }

  void add_facing(int a, int b, int c) {
    const Eigen::Vector3d normal = (place(b) - place(a)).cross(place(c) - place(a));
    if (normal.dot(plane_.normal) < 0) std::swap(b, c);
    add(a, b, c);
  }

  const Eigen::Matrix3Xd& positions_;
  const Plane& plane_;
  PlaneCut& cut_;
  std::vector<Triangle>& triangles_;
  std::map<std::pair<int, int>, int> known_;  // vertices between two of the mesh
};

}  // namespace

Eigen::MatrixXd PlaneCut::values(const Eigen::MatrixXd& of_mesh) const {
  Eigen::MatrixXd own(of_mesh.rows(), std::ssize(vertices));
  for (Eigen::Index v = 0; v < own.cols(); ++v) {
    const Vertex& vertex = vertices[static_cast<std::size_t>(v)];
    own.col(v) = (1 - vertex.share) * of_mesh.col(vertex.from);
    if (vertex.share > 0) own.col(v) += vertex.share * of_mesh.col(vertex.to);
  }
  return own;
}

PlaneCut cut_by_plane(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& surface,
                      const Eigen::Matrix4Xi& tetrahedra, const Plane& plane) {
  PlaneCut cut;
  std::vector<Triangle> triangles;
  PartCut of_surface(positions, plane, cut, triangles), inside(positions, plane, cut, triangles);
  for (const auto& corners : surface.colwise()) of_surface.clip(corners);
  for (const auto& corners : tetrahedra.colwise()) inside.section(corners);
  cut.triangles.resize(3, std::ssize(triangles));
  for (Eigen::Index t = 0; t < cut.triangles.cols(); ++t) {
    const Triangle& own = triangles[static_cast<std::size_t>(t)];
    cut.triangles.col(t) << own[0], own[1], own[2];
  }
  return cut;
}

Eigen::Matrix4Xi tetrahedra_of(const VolumeMesh& mesh) {
  constexpr int kEach = static_cast<int>(kTetrahedraOfHexahedron.size());
  Eigen::Matrix4Xi all(4, mesh.tetrahedra.cols() + kEach * mesh.hexahedra.cols());
  all.leftCols(mesh.tetrahedra.cols()) = mesh.tetrahedra;
  Eigen::Index next = mesh.tetrahedra.cols();
  for (const auto& nodes : mesh.hexahedra.colwise()) {
    for (const auto& corners : kTetrahedraOfHexahedron) all.col(next++) = nodes(corners);
  }
  return all;
}

}  // namespace pliant
