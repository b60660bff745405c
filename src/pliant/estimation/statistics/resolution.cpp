#include "pliant/estimation/statistics/resolution.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double kNumberNoise = 2e-7;  // of the largest number: single precision and conversions
constexpr double kFewestNoises = 20;   // a step is this many times the noise of a number
constexpr std::size_t kFewestDifferent = 5;
constexpr int kLargestDivisor = 12;  // of the smallest distance: that may be several steps

/// The different ones of the numbers, in order.
std::vector<double> different_numbers(std::vector<double> numbers, double noise) {
  std::sort(numbers.begin(), numbers.end());
  const auto same = [&](double a, double b) { return std::abs(a - b) <= 2 * noise; };
  numbers.erase(std::unique(numbers.begin(), numbers.end(), same), numbers.end());
  return numbers;
}

/// The step near `first` of which all distances are multiples; it is sharpened on the way, since
/// far numbers tell it better.
std::optional<double> common_step(const std::vector<double>& numbers, double first, double noise) {
  double step = first, steps = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double distance = numbers[i] - numbers[i - 1];
    const double count = std::round(distance / step);
    // The step itself is known to the noise over the number of steps gone so far.
    const double doubt = 2 * noise + (steps > 0 ? count / steps : count) * 2 * noise;
    if (count < 1 || std::abs(distance - count * step) > std::min(doubt, 0.2 * step)) {
      return std::nullopt;
    }
    steps += count;
    step = (numbers[i] - numbers.front()) / steps;
  }
  return step;
}

bool are_even(const std::vector<double>& numbers, double step) {
  const double range = numbers.back() - numbers.front();
  return std::round(range / step) == static_cast<double>(numbers.size() - 1);
}

}  // namespace

std::optional<double> resolution_of(const std::vector<double>& column) {
  double largest = 0;
  for (const double number : column) largest = std::max(largest, std::abs(number));
  const double noise = kNumberNoise * largest;
  const std::vector<double> numbers = different_numbers(column, noise);
  if (numbers.size() < kFewestDifferent) return std::nullopt;
  double smallest = numbers.back() - numbers.front();
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    smallest = std::min(smallest, numbers[i] - numbers[i - 1]);
  }
  for (int divisor = 1; divisor <= kLargestDivisor; ++divisor) {
    if (smallest / divisor < kFewestNoises * noise) break;
    const auto step = common_step(numbers, smallest / divisor, noise);
    if (!step) continue;
    const bool repeats = numbers.size() < column.size();
    if (!repeats && are_even(numbers, *step)) return std::nullopt;
    return step;
  }
  return std::nullopt;
}

double rounding_sd(double step) { return step / std::sqrt(12.0); }

}  // namespace pliant
