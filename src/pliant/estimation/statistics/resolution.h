#pragma once

#include <optional>
#include <vector>

namespace pliant {

/// The step in which an instrument wrote a column of numbers, in their unit: all of them are whole
/// multiples of it apart, to within what a conversion of units and single precision leave (2e-7 of
/// the largest number).
/// @return nothing where there is no such step (or one below 4e-6 of the largest number), for fewer
/// than five different numbers, and for numbers at even distances that never repeat, whose distance
/// is no resolution
std::optional<double> resolution_of(const std::vector<double>& column);

/// Standard deviation of what a resolution of `step` hides: step / sqrt(12).
double rounding_sd(double step);

}  // namespace pliant
