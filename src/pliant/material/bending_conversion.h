#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/hinge_direction.h"
#include "pliant/material/hinge_slip.h"

namespace pliant {

/// From the bending stiffness of a sheet to that of the hinges of a mesh.
struct BendingConversion {
  /// Hinge stiffness over sheet stiffness of each component. A whole law is multiplied, friction
  /// included.
  BendingVector factors = BendingVector::Ones();
  /// And the friction of each is then put on another scale of strain (`with_hinge_strains`).
  BendingVector slip = BendingVector::Ones();
  /// Stiffness that the sheet then shows, over the one asked for, less 1; by CurvatureDirection.
  /// Near 0 where the mesh can be such a sheet (`bending_conversion`).
  Eigen::Vector4d errors = Eigen::Vector4d::Zero();
};

/// The hinge stiffness with which a mesh, relaxed to a cylinder, shows M/width = 3 k curvature with
/// the sheet's own k along weft, along warp and at 45 degrees, in the limit of small curvature.
///
/// Regular patterns are solved on their periodic cell, other meshes on a piece of their own. Not
/// every mesh can be every sheet: the factors are those of least relative error between 0.01 and
/// 10.
/// - Alternating diagonals: 2 k_diagonal > |k_weft - k_warp| is needed at least, and squares or
///   nearly so.
/// - One diagonal direction: along the two diagonals the stiffness differs by k_weft + k_warp
///   (squares). The softer one, curvature across the diagonals, is made right, and all factors are
///   1; the error of the other one stays.
/// - A mesh of fewer than 30 hinges that is not regular is no sheet: its factors are 1.
/// - Irregular meshes: k_diagonal >= (k_weft + k_warp) / 4 about, and ratios of weft and warp up to
///   about 5. Both directions at 45 degrees count alike.
/// @param hinges           of the mesh
/// @param sheet_stiffness  at zero curvature (N m), > 0
BendingConversion bending_conversion(const TriangleMesh& mesh, const std::vector<Hinge>& hinges,
                                     const BendingVector& sheet_stiffness);

/// The laws of bending of a material. Friction is that of positive strain.
/// @throws AssertionError when a component was not measured
BendingLaws bending_laws(const Material& material);

/// Elastic stiffness at zero curvature of each component (N m).
BendingVector stiffness_at_rest(const BendingLaws& laws);

/// The same for many sheets on one mesh.
class BendingConverter {
 public:
  BendingConverter(const TriangleMesh& mesh, const std::vector<Hinge>& hinges);
  ~BendingConverter();

  /// Of an elastic sheet.
  BendingConversion operator()(const BendingVector& sheet_stiffness) const;

  /// Of a sheet with friction. On irregular meshes its shape is taken as that of an elastic sheet.
  BendingConversion operator()(const BendingLaws& sheet) const;

  /// Of `BendingConversion`, for factors that are known.
  BendingVector slip(const BendingLaws& sheet, const BendingVector& factors) const;

  /// d factors / d sheet stiffness (1/(N m)), a row for each factor: by differences, as factors of
  /// a mesh that can only nearly be such a sheet follow no equation.
  Eigen::Matrix3d factors_by_sheet(const BendingVector& sheet_stiffness) const;

 private:
  struct Mesh;
  std::unique_ptr<const Mesh> mesh_;
};

/// The inverse: what a sheet with given hinges shows, M/width over 3 curvature (N m), by
/// CurvatureDirection.
/// @param hinge_stiffness  at zero curvature (N m), > 0
Eigen::Vector4d sheet_stiffness(const TriangleMesh& mesh, const std::vector<Hinge>& hinges,
                                const BendingVector& hinge_stiffness);

}  // namespace pliant
