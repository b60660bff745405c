#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "pliant/geometry/hinge_direction.h"
#include "pliant/geometry/hinges.h"
#include "pliant/material/cylinder_rigidity.h"

namespace pliant {

/// A piece of a mesh as a linear plate: small heights over the rest plane, bent by its hinges.
///
/// It says what hinges on an irregular mesh amount to. The two outermost rings of vertices are held
/// on a quadratic surface, those inside relax. Energy and mean curvature are taken in the core, out
/// of reach of the rim: the held rim does not relax as the sheet would, and so turns its inside a
/// little away from the surface it imposes. A piece too small to have a core counts as a whole.
/// Large meshes are represented by a piece of 4000 triangles around the vertex that is farthest
/// from any rim or seam.
class PlatePatch {
 public:
  /// @param mesh  with at least one triangle
  explicit PlatePatch(const TriangleMesh& mesh);

  std::size_t hinge_count() const { return hinges_.size(); }

  /// The hinges of the core.
  /// @param hinge_stiffness  N m (or any unit: only ratios matter), > 0
  std::vector<BentHinge> bent(const BendingVector& hinge_stiffness);
  RigidityShares rigidity(const BendingVector& hinge_stiffness) {
    return rigidity_shares(bent(hinge_stiffness));
  }

 private:
  struct PlateHinge {
    std::array<int, 4> vertices{};
    Eigen::RowVector4d bend;  // dihedral angle over the hinge's height, by the vertices' heights
    BendingVector weights;
    double area = 0;       // m^2, of the whole hinge
    double core_area = 0;  // m^2, the part inside the core
  };
  // A vertex a row, an imposed unit curvature (uu, vv, uv) a column.
  using Heights = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  void set_hinges(const TriangleMesh& piece, const std::vector<bool>& core, BendingRule rule);
  void set_surfaces(const TriangleMesh& piece, const std::vector<bool>& core);
  void set_unknowns(const std::vector<int>& depths);
  Heights relaxed(const BendingVector& hinge_stiffness);
  Eigen::SparseMatrix<double> matrix(const BendingVector& hinge_stiffness) const;
  static Eigen::RowVector3d bends(const PlateHinge& hinge, const Heights& heights);

  std::vector<PlateHinge> hinges_;
  Heights surfaces_;               // of curvature 1 / m
  Eigen::Matrix3Xd curvature_of_;  // (uu, vv, uv) of the core by least squares, from all heights
  std::vector<int> unknown_;       // of each vertex; -1 on the rim
  int unknowns_ = 0;
  double core_area_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace pliant
