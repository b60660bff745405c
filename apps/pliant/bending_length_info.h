#pragma once

#include <nlohmann/json.hpp>

#include "pliant/experiment/overhang/overhang_rows.h"

namespace pliant {

/// The readings of an overhang test as the standards report them: an entry for each face that was
/// measured, and for both. Numbers that a single reading or a missing weight cannot tell are null.
/// @param weight  per area (N/m^2); 0: not known
nlohmann::ordered_json bending_length_json(const OverhangRows& rows, double angle, double weight);

}  // namespace pliant
