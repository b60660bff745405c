#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// How well the data of a fit determines a number, by the half width of its 95 % interval.
enum class Determination {
  within_10_percent,
  within_30_percent,
  weak,  ///< its sign is known, or that it is small
  none,  ///< not determined
};

/// "within 10 %", "within 30 %", "weak", "not determined".
std::string_view name_of(Determination determination);

/// The grade of a name that `name_of` gives; nothing for others.
std::optional<Determination> determination_named(std::string_view name);

/// What a fit knows of a number of a material.
struct NumberError {
  std::optional<double> std_error;  ///< in its unit; absent: free in the data, or at its bound
  std::optional<double> limit;      ///< one-sided 95 % limit where it is at its bound
  Determination determined = Determination::none;
  std::string told_by;  ///< the experiments with their shares of the information
};

}  // namespace pliant
