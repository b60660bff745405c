#pragma once

#include <optional>
#include <vector>

#include "pliant/material/density/dahl.h"
#include "pliant/material/density/persistent_deformation.h"
#include "pliant/material/material.h"
#include "pliant/material/snapping_strains.h"

namespace pliant {

/// Stiffness of a component at one strain, in its units (N/m, or N m for bending).
struct StiffnessAt {
  double strain = 0;
  double secant = 0;   ///< elastic stress over strain: the stiffness curve itself
  double tangent = 0;  ///< slope of the elastic stress
  double loading =
      0;  ///< elastic and friction stress over strain, loaded from rest; `secant` at zero strain
};

/// What friction does to a component on one side of zero strain.
struct FrictionFacts {
  DahlParameters dahl;
  /// Persistent and saturation strain by a, tau and the stiffness at zero alone ([T] 5.2.3); none
  /// without stiffness.
  std::optional<FrictionAppearance> appearance;
  /// Strain left by saturated unloading without load, by the whole law; none where friction holds
  /// every strain.
  std::optional<double> persistent_strain;
  /// Where the stress need not fall on unloading, so that a released specimen snaps.
  std::vector<StrainInterval> snapping;
};

/// What the numbers of a component with a stiffness mean.
struct ComponentFacts {
  StiffnessAt at_zero;
  std::optional<StiffnessAt>
      at_end;  ///< of the stated range, or at the last control point; none without either
  std::optional<FrictionFacts> friction;           ///< on the positive side, or on both
  std::optional<FrictionFacts> negative_friction;  ///< where it differs
};

/// @param component  its stiffness is given
ComponentFacts facts_of(const MaterialComponent& component);

}  // namespace pliant
