#pragma once

#include <Eigen/Core>

namespace pliant {

/// Fixed-size types of a strain measure: kinematics of one stencil, without any material.
///
/// A measure `M` derives from StrainTypes<nodes, strains> and has
///   struct Rest                                         what the rest shape gives, computed once
///   static Strain strain(const Rest&, const Positions&)
///   static Gradient gradient(const Rest&, const Positions&)
///   static Hessian weighted_hessian(const Rest&, const Positions&, const Strain& y)   sum_i y_i
///   Hessian(strain_i)
///   static Hessian convex_weighted_hessian(const Rest&, const Positions&, const Strain& y)   a
///   positive semidefinite stand-in for it, equal where that is positive semidefinite by itself or
///   zero
/// and, where strain has several branches,
///   static Rest continued(const Rest&, const Strain& last)   the branch nearest to `last`
/// Node i has the unknowns 3 i .. 3 i + 2. With a density's stress y and tangent dy/dstrain and the
/// rest measure A (m^2 or m^3), force = A gradient^T y and stiffness = A (gradient^T (dy/dstrain)
/// gradient + weighted_hessian(y)).
template <int Nodes, int Strains>
struct StrainTypes {
  static constexpr int kNodes = Nodes;
  static constexpr int kStrains = Strains;
  static constexpr int kUnknowns = 3 * Nodes;

  using Positions = Eigen::Matrix<double, 3, Nodes>;  ///< m, one column a node
  using Strain = Eigen::Matrix<double, Strains, 1>;
  using Gradient = Eigen::Matrix<double, Strains, kUnknowns>;  ///< 1/m times the strain's unit
  using Hessian = Eigen::Matrix<double, kUnknowns, kUnknowns>;
};

}  // namespace pliant
