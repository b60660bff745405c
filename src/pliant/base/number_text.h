#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// The finite number that `text` is as a whole: decimal point, optional sign and exponent, nothing
/// around it. Independent of the locale. NaN, Inf and what overflows a double are no numbers here.
std::optional<double> parse_number(std::string_view text);

/// The whole number that `text` is, without a decimal point or exponent.
std::optional<long> parse_integer(std::string_view text);

/// The shortest text from which `parse_number` gives back the same bits.
std::string format_number(double value);

/// `value` rounded to `digits` significant digits, without trailing zeros.
std::string format_number(double value, int digits);

/// `text` without blanks (space, tab, CR, LF) at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace pliant
