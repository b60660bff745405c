#pragma once

#include <string>
#include <vector>

#include "pliant/material/density/sum.h"
#include "pliant/material/material.h"

namespace pliant {

/// How Dahl friction enters a time step (docs/architecture.md).
enum class FrictionForm {
  variational,  ///< the exact branches from the last accepted strain, an incremental potential
  linearized,   ///< [T] Eq. 5.9, as published
};

/// What a simulation makes of a material's components.
struct DensityOptions {
  bool friction = true;
  FrictionForm friction_form = FrictionForm::variational;
  double damping_fraction = 0;  ///< of the stiffness at unit strain, times 1 s
};

/// Which laws of a component: energies have limits, and what remembers has none.
enum class LawPart {
  all,
  elastic,  ///< what remembers nothing
  rest,     ///< friction, other addends that remember, damping
};

/// Names of what a component's law adds to a sum, in their order.
struct AddedNames {
  std::vector<std::string> parameters;  ///< "stretch.weft.k1", ...
  std::vector<std::string> history;     ///< "friction.stretch.weft"
};

/// Adds the law of a component to a sum: elasticity, friction and damping.
/// @param component  its name, e.g. "stretch.weft"; it must have a stiffness
/// @param strain     which strain of the sum it acts on
/// @return the names of what it adds
AddedNames add_component(const Material& material, const std::string& component, int strain,
                         const DensityOptions& options, Sum& sum, LawPart part = LawPart::all);

}  // namespace pliant
