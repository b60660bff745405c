#pragma once

#include <memory>

#include "pliant/material/component_density.h"

namespace pliant {

/// The law of a solid's material points on six strains (`kSolidStrains`), as simulations take it.
struct SolidDensity {
  std::shared_ptr<Sum> law;  ///< an addend for each component that has a law
  AddedNames names;          ///< of its parameters and of its history, in their order
};

/// Builds the law of a solid: each of its components acts on its metric of the Green strain
/// ([T] Eq. 4.1).
/// @param material  of kind solid; components without numbers add nothing. Principal stretches get
///                  no damping: which is which changes
SolidDensity solid_density(const Material& material, const DensityOptions& options = {});

}  // namespace pliant
