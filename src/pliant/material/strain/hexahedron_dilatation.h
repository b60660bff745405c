#pragma once

#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// The relative change of a hexahedron's volume, V / V0 - 1: one for the whole element, so that a
/// material of nearly constant volume does not lock in it (mean dilatation; Nagtegaal, Parks and
/// Rice 1974). Nodes as of a VolumeMesh.
struct HexahedronDilatation : StrainTypes<8, 1> {
  struct Rest {
    double volume = 0;  ///< V0, m^3
  };

  static Strain strain(const Rest& rest, const Positions& positions);
  static Gradient gradient(const Rest& rest, const Positions& positions);
  static Hessian weighted_hessian(const Rest& rest, const Positions& positions, const Strain& y);
  /// Zero: what a pressure does as the volume's gradient turns has as much of either sign.
  static Hessian convex_weighted_hessian(const Rest&, const Positions&, const Strain&) {
    return Hessian::Zero();
  }
};

}  // namespace pliant
