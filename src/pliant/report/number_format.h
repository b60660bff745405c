#pragma once

#include <optional>
#include <string>

namespace pliant::report {

/// What stands where a number is not known.
inline constexpr const char* kNoValue = "–";

/// A number with so many significant digits: `0.0314`, `1250`, `6.2 × 10⁻⁶`; kNoValue for none or
/// one that is not finite.
std::string format_significant(std::optional<double> value, int digits);

/// A percentage with two significant digits, at most one decimal: `0.3 %`, `1.4 %`, `12 %`.
std::string format_percent(std::optional<double> percent);

/// Writes numbers that belong to one uncertain value alike: as many decimals as leave the standard
/// error two significant digits, and one common power of ten.
class UncertainFormat {
 public:
  /// Without a standard error the value has four significant digits.
  UncertainFormat(std::optional<double> value, std::optional<double> std_error);

  std::string operator()(std::optional<double> number) const;

 private:
  int exponent_ = 0;
  int decimals_ = 0;
};

}  // namespace pliant::report
