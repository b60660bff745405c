#pragma once

#include "pliant/geometry/volume_mesh.h"
#include "pliant/scene/solid.h"

namespace pliant {

/// The one material that those of a solid's samples are together ([T] 4.2.4). Samples may differ in
/// their components as well as in numbers; of a component the material itself has that of the first
/// sample with one.
/// @param mesh  in the solid's own coordinates
/// @throws InputError for a sample outside the body, two at one place, and materials that cannot be
///         blended: that remember, have samples themselves or limits of energy
Material sampled_material(const SceneSolid& solid, const VolumeMesh& mesh);

/// Mass per volume of each sample (kg/m^3).
Eigen::VectorXd densities_of(const SceneSolid& solid);

}  // namespace pliant
