#pragma once

#include <array>

namespace pliant::report {

/// Colours of position residuals, from none to the largest of a session; they darken evenly, so
/// that they are told apart in grey print.
inline constexpr std::array<const char*, 6> kResidualColours = {"#e6edf3", "#f7dfb5", "#f2bb6b",
                                                                "#e08c33", "#b85a12", "#7a2c05"};

/// Of a residual as a part of the largest, 0 to 1.
inline const char* residual_colour(double part) {
  const double place = part * static_cast<double>(kResidualColours.size());
  return place < 1 ? kResidualColours.front()
         : place < static_cast<double>(kResidualColours.size())
             ? kResidualColours[static_cast<std::size_t>(place)]
             : kResidualColours.back();
}

}  // namespace pliant::report
