#pragma once

#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// Bending strain of a hinge, two triangles that share an edge ([T] 5.2.1, Eq. 3.5): 3 (theta -
/// theta0) / h. Gradient and Hessian of theta are the closed forms of [Tamstorf2013].
///
/// Nodes: the edge's two ends, then the opposite vertex of the triangle that has the edge in this
/// direction, then that of the other. theta is the signed angle between the normals, continued
/// through +-pi: the branch nearest to `Rest::near_angle` counts, which follows the last accepted
/// angle (it is state).
struct DiscreteShells : StrainTypes<4, 1> {
  struct Rest {
    double angle = 0;       ///< theta0
    double height = 0;      ///< h, mean height of the two triangles over the edge (m)
    double near_angle = 0;  ///< the branch of theta: that within pi of this angle
  };

  static Strain strain(const Rest& rest, const Positions& positions);
  static Gradient gradient(const Rest& rest, const Positions& positions);
  static Hessian weighted_hessian(const Rest& rest, const Positions& positions, const Strain& y);
  /// Zero: of a hinge's stiffness, what its own stress does is indefinite and small.
  static Hessian convex_weighted_hessian(const Rest&, const Positions&, const Strain&) {
    return Hessian::Zero();
  }
  /// Within a step a hinge may turn by a quarter beyond where it was, and by three quarters the
  /// other way, through flat: a fold that springs open turns far.
  static Rest continued(const Rest& rest, const Strain& last);
};

/// Signed angle between the normals of a hinge's triangles, in (-pi, pi]; 0 where they are
/// coplanar.
double dihedral_angle(const DiscreteShells::Positions& positions);

/// The angle among angle + 2 pi n that is nearest to `near`.
double continued_angle(double angle, double near);

}  // namespace pliant
