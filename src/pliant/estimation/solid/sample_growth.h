#pragma once

#include "pliant/estimation/solid/solid_growth.h"

namespace pliant {

/// Gives a solid samples, one after the other while one or two more are worth it (`is_worth`), each
/// where the differences ask for it most: of all places that it may have the one with which the
/// linearised problem comes closest to the data. The first two are chosen together.
/// @param options  of the study's model; how many at most, of which components, and of which width
/// @param choices  places that samples may have, with the width of all of them
/// @param uniform  the solid that is the same everywhere, fitted
GrownSolid with_samples(SolidProblem& problem, const SampleOptions& options,
                        const MaterialSamples& choices, const GrownSolid& uniform);

}  // namespace pliant
