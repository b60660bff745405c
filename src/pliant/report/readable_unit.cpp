#include "pliant/report/readable_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/report/plot_style.h"

namespace pliant::report {
namespace {

struct Prefix {
  std::string_view letter;
  double factor;
};

constexpr std::array<Prefix, 6> kPrefixes = {
    {{"n", 1e-9}, {"µ", 1e-6}, {"m", 1e-3}, {"", 1}, {"k", 1e3}, {"M", 1e6}}};

constexpr double kSmallest = 0.1, kLargest = 1e4;  // what is read without a prefix

/// `N m` of `mN m`, with the factor of the prefix; nothing for what is no unit of force.
std::optional<std::pair<std::string_view, double>> without_prefix(std::string_view unit) {
  for (const Prefix& prefix : kPrefixes) {
    if (!unit.starts_with(prefix.letter)) continue;
    const std::string_view base = unit.substr(prefix.letter.size());
    if (base == "N" || base.starts_with("N ") || base.starts_with("N/")) {
      return std::pair(base, prefix.factor);
    }
  }
  return std::nullopt;
}

/// `N m^2` -> `N m²`
std::string with_superscripts(std::string_view unit) {
  std::string text(unit);
  for (std::size_t at = text.find("^2"); at != text.npos; at = text.find("^2")) {
    text.replace(at, 2, "²");
  }
  return text;
}

/// Whether a trace is drawn on the first axis of that letter.
bool is_on(const nlohmann::json& trace, const std::string& letter) {
  return trace.value(letter + "axis", letter) == letter;
}

double largest_size(const nlohmann::json& traces, const std::string& letter) {
  double largest = 0;
  for (const auto& trace : traces) {
    if (!is_on(trace, letter)) continue;
    for (const auto& value : trace.at(letter)) {
      if (value.is_number()) largest = std::max(largest, std::abs(value.get<double>()));
    }
  }
  return largest;
}

void multiply(nlohmann::json& numbers, double factor) {
  std::vector<double> values;
  for (const auto& value : numbers) {
    values.push_back(value.is_number() ? factor * value.get<double>() : std::nan(""));
  }
  numbers = plot_numbers(values);
}

}  // namespace

ReadableUnit readable_unit(std::string_view unit, double size) {
  const ReadableUnit as_it_is{with_superscripts(unit), 1};
  const auto plain = without_prefix(unit);
  size = std::abs(size);
  if (!plain || !(size > 0) || !std::isfinite(size)) return as_it_is;
  if (size >= kSmallest && size < kLargest) return as_it_is;
  const auto& [base, factor] = *plain;
  const Prefix* best = kPrefixes.data();
  for (const Prefix& prefix : kPrefixes) {
    if (size * factor >= prefix.factor) best = &prefix;
  }
  return {std::string(best->letter) + with_superscripts(base), factor / best->factor};
}

void set_readable_axis(Figure& figure, char axis_letter, const QuantityLabel& label, bool compact) {
  const std::string letter(1, axis_letter);
  const ReadableUnit unit = readable_unit(label.unit, largest_size(figure.traces, letter));
  for (auto& trace : figure.traces) {
    if (unit.factor != 1 && is_on(trace, letter)) multiply(trace.at(letter), unit.factor);
  }
  figure.layout[letter + "axis"] = axis({label.name, unit.name}, compact);
}

}  // namespace pliant::report
