#include "pliant/material/plate_patch.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>

#include "pliant/base/assert.h"
#include "pliant/geometry/rest_patch.h"

namespace pliant {
namespace {

// docs/architecture.md, Bending: sheets and hinges (irregular meshes).
constexpr int kMaxTriangles = 4000;
constexpr int kHeldDepth = 1;  // vertices up to this depth are held: their height and their slope
// What the rim does to the vertices inside decays within two or three edges.
constexpr int kCoreDepth = 4;
constexpr int kMinCoreTriangles = 100;

using Vector2 = Eigen::Vector2d;

// Which triangles count; all of them where too few lie deep enough.
std::vector<bool> core_triangles(const RestPatch& patch) {
  std::vector<bool> core(patch.mesh.triangle_count());
  for (int t = 0; t < patch.mesh.triangle_count(); ++t) {
    const Eigen::Vector3i corners = patch.mesh.triangles.col(t);
    core[t] = std::all_of(corners.begin(), corners.end(),
                          [&](int vertex) { return patch.depths[vertex] >= kCoreDepth; });
  }
  if (std::count(core.begin(), core.end(), true) < kMinCoreTriangles)
    core.assign(core.size(), true);
  return core;
}

// Dihedral angle for small heights w over the rest plane: on each side the opposite vertex rises
// over the point of the edge beneath it, by the slope (w_opposite - w_foot) / height.
Eigen::RowVector4d small_angle(const Hinge& hinge, const Eigen::Matrix3Xd& positions) {
  const Vector2 start = positions.col(hinge.vertices[0]).head<2>();
  const double length = hinge.rest_edge.norm();
  const Vector2 along = hinge.rest_edge / length;
  Eigen::RowVector4d angle = Eigen::RowVector4d::Zero();
  for (int side = 0; side < 2; ++side) {
    const Vector2 to = positions.col(hinge.vertices[2 + side]).head<2>() - start;
    const double share = to.dot(along) / length;
    const double height = std::abs(along.x() * to.y() - along.y() * to.x());
    angle(0) -= (1 - share) / height;
    angle(1) -= share / height;
    angle(2 + side) = 1 / height;
  }
  return angle;
}

}  // namespace

PlatePatch::PlatePatch(const TriangleMesh& mesh) {
  const RestPatch patch = rest_patch(mesh, kMaxTriangles);
  const std::vector<bool> core = core_triangles(patch);
  set_hinges(patch.mesh, core, bending_rule(mesh));
  set_surfaces(patch.mesh, core);
  set_unknowns(patch.depths);
}

void PlatePatch::set_hinges(const TriangleMesh& piece, const std::vector<bool>& core,
                            BendingRule rule) {
  const std::vector<Hinge> hinges = find_hinges(piece);
  const std::vector<BendingVector> weights = bending_weights(hinges, rule);
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    PlateHinge& plate = hinges_.emplace_back();
    plate.vertices = hinge.vertices;
    plate.bend = small_angle(hinge, piece.positions) / hinge.height;
    plate.weights = weights[i];
    plate.area = hinge.area;
    // A third of each of its triangles belongs to a hinge.
    for (const int t : hinge.triangles) {
      if (core[t]) plate.core_area += rest_area(piece, t) / 3;
    }
  }
  for (int t = 0; t < piece.triangle_count(); ++t) {
    if (core[t]) core_area_ += rest_area(piece, t);
  }
}

void PlatePatch::set_surfaces(const TriangleMesh& piece, const std::vector<bool>& core) {
  const Eigen::Vector3d centre = piece.positions.rowwise().mean();
  const double size = std::sqrt(rest_area(piece));  // makes the polynomials of equal size
  surfaces_.resize(piece.vertex_count(), 3);
  Eigen::Matrix<double, 6, Eigen::Dynamic> polynomials(6, piece.vertex_count());
  for (int i = 0; i < piece.vertex_count(); ++i) {
    const Eigen::Vector3d x = piece.positions.col(i) - centre;
    surfaces_.row(i) << x.x() * x.x() / 2, x.y() * x.y() / 2, x.x() * x.y();
    polynomials.col(i) << surfaces_.row(i).transpose() / (size * size), x.head<2>() / size, 1;
  }
  // A vertex counts with its triangles in the core.
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(piece.vertex_count());
  for (int t = 0; t < piece.triangle_count(); ++t) {
    if (!core[t]) continue;
    for (int k = 0; k < 3; ++k) weights(piece.triangles(k, t)) += rest_area(piece, t);
  }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> weighted = polynomials * weights.asDiagonal();
  const Eigen::Matrix<double, 6, 6> normal = weighted * polynomials.transpose();
  curvature_of_ =
      (normal.completeOrthogonalDecomposition().solve(weighted)).topRows<3>() / (size * size);
}

void PlatePatch::set_unknowns(const std::vector<int>& depths) {
  for (const int depth : depths) unknown_.push_back(depth > kHeldDepth ? unknowns_++ : -1);
  if (unknowns_ > 0) factor_.analyzePattern(matrix(BendingVector::Ones()));
}

Eigen::RowVector3d PlatePatch::bends(const PlateHinge& hinge, const Heights& heights) {
  Eigen::RowVector3d result = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 4; ++k) result += hinge.bend(k) * heights.row(hinge.vertices[k]);
  return result;
}

Eigen::SparseMatrix<double> PlatePatch::matrix(const BendingVector& hinge_stiffness) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const PlateHinge& hinge : hinges_) {
    const double stiffness = hinge.area * hinge.weights.dot(hinge_stiffness);
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) {
        const int row = unknown_[hinge.vertices[k]], column = unknown_[hinge.vertices[l]];
        if (row < column || column < 0) continue;
        entries.emplace_back(row, column, stiffness * hinge.bend(k) * hinge.bend(l));
      }
    }
  }
  Eigen::SparseMatrix<double> lower(unknowns_, unknowns_);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

PlatePatch::Heights PlatePatch::relaxed(const BendingVector& hinge_stiffness) {
  Heights heights = surfaces_;
  if (unknowns_ == 0) return heights;
  Heights force = Heights::Zero(unknowns_, 3);
  for (const PlateHinge& hinge : hinges_) {
    const Eigen::RowVector3d stress =
        hinge.area * hinge.weights.dot(hinge_stiffness) * bends(hinge, heights);
    for (int k = 0; k < 4; ++k) {
      const int row = unknown_[hinge.vertices[k]];
      if (row >= 0) force.row(row) -= hinge.bend(k) * stress;
    }
  }
  factor_.factorize(matrix(hinge_stiffness));
  PLIANT_ASSERT(factor_.info() == Eigen::Success, "hinges with stiffness make a stiff plate");
  const Heights moved = factor_.solve(force);
  for (Eigen::Index i = 0; i < heights.rows(); ++i) {
    if (unknown_[i] >= 0) heights.row(i) += moved.row(unknown_[i]);
  }
  return heights;
}

std::vector<BentHinge> PlatePatch::bent(const BendingVector& hinge_stiffness) {
  PLIANT_ASSERT((hinge_stiffness.array() > 0).all(), "hinges have a positive stiffness");
  const Heights heights = relaxed(hinge_stiffness);
  // What to impose for the core to have the curvature of a cylinder, one a column.
  Eigen::Matrix3d core_curvature = Eigen::Matrix3d::Identity();
  if (unknowns_ > 0) core_curvature = curvature_of_ * heights;
  const Eigen::Matrix<double, 3, 4> imposed =
      core_curvature.inverse() * cylinder_curvatures().transpose();
  std::vector<BentHinge> result;
  for (const PlateHinge& hinge : hinges_) {
    if (hinge.core_area == 0) continue;
    // Of the energies k (3 bend)^2 / 2 an area and 3 k curvature^2 / 2: a factor of three is left.
    result.push_back(
        {hinge.weights, 3 * hinge.core_area / core_area_, bends(hinge, heights) * imposed});
  }
  return result;
}

}  // namespace pliant
