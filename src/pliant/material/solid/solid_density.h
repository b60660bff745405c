#pragma once

#include "pliant/material/component_sum.h"

namespace pliant {

/// The law of a solid's material points by a law of one strain on a metric.
/// @param metric  the name of one (metric.h, pair_metric.h, principal_metric.h)
std::shared_ptr<const ParametricDensity> law_on_metric(
    const std::string& metric, std::shared_ptr<const ParametricDensity> law);

/// The law of a solid's material points on six strains (`kSolidStrains`), as simulations take it:
/// each component acts on its metric of the Green strain ([T] Eq. 4.1).
/// @param material  of kind solid; components without numbers add nothing. Principal stretches get
///                  no damping: which is which changes
NamedLaw solid_density(const Material& material, const DensityOptions& options = {});

}  // namespace pliant
