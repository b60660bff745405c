#include "pliant/report/number_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace pliant::report {
namespace {

/// Outside 10^kSmallest .. 10^kLargest numbers are written with a power of ten.
constexpr int kSmallest = -4;
constexpr int kLargest = 6;

constexpr int kMaxDecimals = 12;

/// The power of ten of the first significant digit, once rounded to so many digits.
int leading_exponent(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, std::max(digits - 1, 0));
  return std::stoi(text.substr(text.find('e') + 1));
}

std::string superscript(int exponent) {
  constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                        "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(exponent)) {
    text += c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

std::string fixed(double value, int exponent, int decimals) {
  const std::string mantissa = fmt::format("{:.{}f}", value / std::pow(10.0, exponent),
                                           std::clamp(decimals, 0, kMaxDecimals));
  return exponent == 0 ? mantissa : mantissa + " × 10" + superscript(exponent);
}

bool usable(std::optional<double> value) { return value && std::isfinite(*value); }

int common_exponent(int leading) { return leading < kSmallest || leading > kLargest ? leading : 0; }

/// Rounded to the left of the decimal point too: 12345 with two digits is 12000.
double rounded(double value, int decimals) {
  if (decimals >= 0) return value;
  const double step = std::pow(10.0, -decimals);
  return std::round(value / step) * step;
}

}  // namespace

std::string format_significant(std::optional<double> value, int digits) {
  if (!usable(value)) return kNoValue;
  if (*value == 0.0) return "0";
  const int leading = leading_exponent(*value, digits);
  const int exponent = common_exponent(leading);
  const int decimals = digits - 1 - leading + exponent;
  return fixed(rounded(*value, decimals), exponent, decimals);
}

std::string format_percent(std::optional<double> percent) {
  if (!usable(percent)) return kNoValue;
  const double magnitude = std::abs(*percent);
  if (magnitude > 0 && magnitude < 0.05) return "< 0.1 %";
  return fmt::format("{:.{}f} %", *percent, magnitude < 9.95 ? 1 : 0);
}

UncertainFormat::UncertainFormat(std::optional<double> value, std::optional<double> std_error) {
  constexpr int kErrorDigits = 2;
  constexpr int kValueDigits = 4;
  const bool has_value = usable(value) && *value != 0.0;
  const bool has_error = usable(std_error) && *std_error > 0.0;
  if (!has_value && !has_error) return;
  const double largest = std::max(has_value ? std::abs(*value) : 0.0, has_error ? *std_error : 0.0);
  const int leading = leading_exponent(largest, kValueDigits);
  exponent_ = common_exponent(leading);
  const int last_digit = has_error ? leading_exponent(*std_error, kErrorDigits) - kErrorDigits + 1
                                   : leading - kValueDigits + 1;
  decimals_ = exponent_ - last_digit;
}

std::string UncertainFormat::operator()(std::optional<double> number) const {
  if (!usable(number)) return kNoValue;
  return fixed(rounded(*number, decimals_), exponent_, decimals_);
}

}  // namespace pliant::report
