#pragma once

#include <string>
#include <vector>

namespace pliant {

/// How numbers of one range are written beside a scale.
struct NumberScale {
  std::vector<double> ticks;  ///< round numbers in the range, ascending, in the unit of the values
  int exponent = 0;           ///< labels give the values divided by 10^exponent; a multiple of 3
  int decimals = 0;           ///< of the labels

  std::string label(double value) const;
};

/// At most `count` + 1 ticks a step of 1, 2 or 5 times a power of ten apart; two or more where
/// `low` < `high`, one where they are equal.
/// @param count  at least 2
NumberScale number_scale(double low, double high, int count);

/// The least of 1, 2 and 5 times a power of ten that is not below `rough`, but for rounding.
/// @param rough  > 0
double round_step(double rough);

/// Decimals that tell numbers `spacing` apart from each other, within 2 % of it; at most 6.
int decimals_for(double spacing);

}  // namespace pliant
