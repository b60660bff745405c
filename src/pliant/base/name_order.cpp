#include "pliant/base/name_order.h"

#include <algorithm>
#include <compare>

namespace pliant {
namespace {

bool begins_with_digit(std::string_view text) {
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

/// Takes the digits at the start of a text away.
/// @return them, without leading zeros
std::string_view take_number(std::string_view& text) {
  const std::size_t size = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, size);
  text.remove_prefix(size);
  return digits.substr(std::min(digits.find_first_not_of('0'), size));
}

/// Takes the first number or letter of both away.
std::strong_ordering compare_first(std::string_view& one, std::string_view& other) {
  if (begins_with_digit(one) && begins_with_digit(other)) {
    const std::string_view a = take_number(one), b = take_number(other);
    return a.size() != b.size() ? a.size() <=> b.size() : a <=> b;
  }
  const auto order = one.substr(0, 1) <=> other.substr(0, 1);
  one.remove_prefix(1);
  other.remove_prefix(1);
  return order;
}

}  // namespace

bool comes_before(std::string_view one, std::string_view other) {
  std::string_view a = one, b = other;
  while (!a.empty() && !b.empty()) {
    const auto order = compare_first(a, b);
    if (order != 0) return order < 0;
  }
  if (a.empty() && b.empty()) return one < other;  // they differ by leading zeros
  return a.empty();
}

}  // namespace pliant
