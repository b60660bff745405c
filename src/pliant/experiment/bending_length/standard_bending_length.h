#pragma once

#include "pliant/experiment/bending_length/overhang_rows.h"
#include "pliant/experiment/standard_figures.h"

namespace pliant {

/// The readings of an overhang test as the standards report them: an entry for each face that was
/// measured, and for both. Numbers that a single reading or a missing weight cannot tell are null.
/// @param weight  per area (N/m^2); 0: not known
StandardFigures standard_bending_length(const OverhangRows& rows, double angle, double weight);

}  // namespace pliant
