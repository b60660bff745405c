#include "pliant/io/vector_fields.h"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "pliant/base/number_text.h"

namespace pliant {
namespace {

/// The texts on both sides of the only `x`.
std::optional<std::pair<std::string, std::string>> split_at_times(const std::string& text) {
  const std::size_t at = text.find('x');
  if (at == std::string::npos || text.find('x', at + 1) != std::string::npos) return std::nullopt;
  return std::pair(std::string(trimmed(text.substr(0, at))),
                   std::string(trimmed(text.substr(at + 1))));
}

double positive_length(const Value& value, const std::string& text) {
  try {
    const double length = parse_quantity(text, Dimension::length);
    if (length > 0) return length;
  } catch (const QuantityError& error) {
    value.fail(error.problem(), error.expected());
  }
  value.fail(quoted_value(text) + " is not positive", "a length above 0");
}

}  // namespace

Eigen::Vector3d read_vector(const Value& value) {
  const std::vector<double> numbers = value.numbers();
  if (numbers.size() != 3) {
    value.fail(fmt::format("has {} numbers", numbers.size()), "a vector [x, y, z] in SI");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::pair<double, double> read_extents(const Value& value) {
  const std::string text = value.text();
  const auto sides = split_at_times(text);
  if (!sides) value.fail(quoted_value(text) + " is no size", "WIDTH x HEIGHT, e.g. 100 mm x 50 mm");
  return {positive_length(value, sides->first), positive_length(value, sides->second)};
}

std::pair<int, int> read_counts(const Value& value, int low, int high) {
  const std::string text = value.text();
  const auto sides = split_at_times(text);
  const auto count = [&](const std::string& side) {
    const std::optional<long> number = parse_integer(side);
    return number && *number >= low && *number <= high ? static_cast<int>(*number) : low - 1;
  };
  const std::pair counts =
      sides ? std::pair(count(sides->first), count(sides->second)) : std::pair(low - 1, low - 1);
  if (counts.first < low || counts.second < low) {
    value.fail(quoted_value(text),
               fmt::format("two whole numbers from {} to {}, e.g. 25x13", low, high));
  }
  return counts;
}

}  // namespace pliant
