#pragma once

#include "pliant/mechanics/solid_field.h"
#include "pliant/scene/solid.h"

namespace pliant {

/// The field of a heterogeneous solid's material samples.
/// @param mesh  in the solid's own coordinates
/// @throws InputError for a sample outside the body, two at one place, and materials that cannot be
///         blended: that remember, have limits of energy, or of which some resist a change of
///         volume by a component J and others do not
SolidField solid_field(const SceneSolid& solid, const VolumeMesh& mesh);

}  // namespace pliant
