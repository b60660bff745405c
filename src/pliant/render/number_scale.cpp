#include "pliant/render/number_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr int kMostDecimals = 6;
// Numbers from 0.001 to 100,000 are written out.
constexpr double kSmallestPlain = 1e-3, kLargestPlain = 1e5;

std::vector<double> multiples_in(double low, double high, double step) {
  const double slack = 1e-9 * (high - low);
  std::vector<double> multiples;
  for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i) {
    multiples.push_back(i * step);
  }
  return multiples;
}

int exponent_of(double largest) {
  if (largest == 0 || (largest >= kSmallestPlain && largest < kLargestPlain)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
}

}  // namespace

std::string NumberScale::label(double value) const {
  const double shown = value / std::pow(10.0, exponent);
  // No "-0.0" for what rounds to zero.
  const double half_digit = 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", std::abs(shown) < half_digit ? 0.0 : shown, decimals);
}

NumberScale number_scale(double low, double high, int count) {
  NumberScale scale;
  scale.exponent = exponent_of(std::max(std::abs(low), std::abs(high)));
  if (!(high > low)) {
    scale.ticks = {low};
    scale.decimals = 3;
    return scale;
  }
  double step = round_step((high - low) / count);
  scale.ticks = multiples_in(low, high, step);
  while (scale.ticks.size() < 2) {  // the step is too long for this place of the range
    step = round_step(step / 2.5);
    scale.ticks = multiples_in(low, high, step);
  }
  scale.decimals = decimals_for(step / std::pow(10.0, scale.exponent));
  return scale;
}

double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    // Rounding must not push a step that is round itself to the next one.
    if (factor * power >= rough * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

int decimals_for(double spacing) {
  for (int decimals = 0; decimals < kMostDecimals; ++decimals) {
    const double power = std::pow(10.0, decimals);
    if (std::abs(std::round(spacing * power) / power - spacing) <= 0.02 * spacing) return decimals;
  }
  return kMostDecimals;
}

}  // namespace pliant
