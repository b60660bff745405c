#pragma once

#include "pliant/material/material.h"
#include "pliant/study/study.h"

namespace pliant {

/// Where the model of a study has samples of a heterogeneous solid, or may have them, and their
/// width; without components. None where the solid is the same everywhere.
/// @throws InputError where an experiment to be fitted is of no body, for places outside the first
///         one's, for two at one place, and for more than it has nodes
MaterialSamples body_samples(const Study& study);

/// The body of the first experiment that is fitted, at rest; null where it is of a piece.
const VolumeMesh* body_of_samples(const Study& study);

}  // namespace pliant
