#include "pliant/base/plausibility.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant {
namespace {

constexpr int kDigits = 4;
constexpr std::size_t kMostSlips = 3;
/// Units nearer than that are no slip that a range could tell.
constexpr double kNotableFactor = 3;

/// By which a size that a document states is likely to be wrong: places of its decimal point, and
/// ounces per square yard for g/m^2.
std::vector<double> usual_factors(Dimension dimension) {
  std::vector<double> factors{0.1, 10, 0.01, 100, 1e-3, 1e3};
  if (dimension == Dimension::area_density)
    factors.push_back(*unit_scale("oz/yd^2", dimension) / 1e-3);
  return factors;
}

/// Units that testers write. Fractions have one beside per cent: none.
std::vector<std::string> usual_units(Dimension dimension) {
  if (dimension == Dimension::fraction) return {"%", "1"};
  std::vector<std::string> units = units_of(dimension);
  std::erase_if(units, [](const std::string& unit) { return unit.starts_with("u"); });
  return units;
}

double scale_of(const std::string& unit, Dimension dimension) {
  if (unit.empty() || unit == "1") return 1;
  return unit_scale(unit, dimension).value_or(1);
}

/// A header's spelling of a unit, as it is usually written: `N/m` of `N_per_m`.
std::string usual_spelling(const std::string& unit, Dimension dimension) {
  for (const std::string& usual : usual_units(dimension)) {
    if (usual != "1" && scale_of(usual, dimension) == scale_of(unit, dimension)) return usual;
  }
  return unit;
}

/// From the middle of a figure's range: 1 at its ends.
double distance_from_middle(const FabricFigure& figure, double value) {
  const double middle = std::sqrt(figure.least * figure.most);
  return std::log(value / middle) / std::log(figure.most / middle);
}

std::string fact(const FabricFigure& figure, double value) {
  return fmt::format(fmt::runtime(figure.sentence),
                     format_quantity(value, figure.dimension, kDigits));
}

}  // namespace

bool is_plausible(const FabricFigure& figure, double value) {
  return value >= figure.least && value <= figure.most;
}

Plausibility::Reading Plausibility::column(std::string name, Dimension dimension,
                                           std::string unit) {
  sources_.push_back({std::move(name), dimension, std::move(unit), std::nullopt});
  return sources_.size() - 1;
}

Plausibility::Reading Plausibility::field(std::string name, Dimension dimension, double value) {
  sources_.push_back({std::move(name), dimension, {}, value});
  return sources_.size() - 1;
}

void Plausibility::add(const FabricFigure& figure, double value, std::vector<Power> powers) {
  shown_.push_back({&figure, {value, std::move(powers)}, std::nullopt});
}

void Plausibility::add_above(double limit, const Figure& other, const FabricFigure& figure,
                             const Figure& value) {
  shown_.push_back({&figure, value, Condition{other, limit, INFINITY}});
}

void Plausibility::add_below(double limit, const Figure& other, const FabricFigure& figure,
                             const Figure& value) {
  shown_.push_back({&figure, value, Condition{other, -INFINITY, limit}});
}

double Plausibility::mended(const Figure& figure, Reading reading, double factor) {
  double value = figure.value;
  for (const Power& power : figure.powers) {
    if (power.reading == reading) value *= std::pow(factor, power.exponent);
  }
  return value;
}

std::optional<double> Plausibility::asked(const Shown& shown, Reading reading, double factor) {
  if (shown.condition) {
    const double other = mended(shown.condition->other, reading, factor);
    if (other <= shown.condition->least || other >= shown.condition->most) return std::nullopt;
  }
  return mended(shown.figure, reading, factor);
}

void Plausibility::try_slip(Reading reading, double factor, std::string words,
                            std::vector<Slip>& slips) const {
  if (std::abs(std::log(factor)) < std::log(kNotableFactor)) return;
  Slip slip{std::move(words)};
  for (const Shown& shown : shown_) {
    const std::optional<double> value = asked(shown, reading, factor);
    if (!value) continue;
    if (!is_plausible(*shown.range, *value)) return;
    slip.distance += std::pow(distance_from_middle(*shown.range, *value), 2);
  }
  slips.push_back(std::move(slip));
}

std::vector<Plausibility::Slip> Plausibility::slips() const {
  std::vector<Slip> slips;
  for (Reading r = 0; r < sources_.size(); ++r) {
    const Source& source = sources_[r];
    if (source.value) {
      for (const double factor : usual_factors(source.dimension)) {
        const auto text = [&](double value) {
          return format_quantity(value, source.dimension, kDigits);
        };
        try_slip(r, factor,
                 fmt::format("`{}` {}, not {}", source.name, text(factor * *source.value),
                             text(*source.value)),
                 slips);
      }
      continue;
    }
    const double read = scale_of(source.unit, source.dimension);
    for (const std::string& unit : usual_units(source.dimension)) {
      const std::string in = unit == "1" ? "a fraction" : "in " + unit;
      try_slip(
          r, scale_of(unit, source.dimension) / read,
          fmt::format(
              "`{}` {}{}", source.name, in,
              source.unit.empty() ? "" : ", not " + usual_spelling(source.unit, source.dimension)),
          slips);
    }
  }
  std::ranges::stable_sort(slips, {}, &Slip::distance);
  return slips;
}

std::optional<std::string> Plausibility::question() const {
  const auto odd = std::ranges::find_if(shown_, [](const Shown& shown) {
    const std::optional<double> value = asked(shown, 0, 1);
    return value && !is_plausible(*shown.range, *value);
  });
  if (odd == shown_.end()) return std::nullopt;
  std::vector<std::string> likely;
  for (const Slip& slip : slips()) {
    if (likely.size() < kMostSlips) likely.push_back(slip.words);
  }
  std::string words = fmt::format("is {}", fmt::join(likely, ", or is "));
  if (likely.empty()) {
    std::vector<std::string> names;
    for (const Power& power : odd->figure.powers) {
      const std::string name = "`" + sources_[power.reading].name + "`";
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    words = fmt::format("are the numbers and units of {} right", fmt::join(names, " and "));
  }
  const FabricFigure& figure = *odd->range;
  return fmt::format("{}: {}? (fabrics: {} to {})", fact(figure, odd->figure.value), words,
                     format_quantity(figure.least, figure.dimension, kDigits),
                     format_quantity(figure.most, figure.dimension, kDigits));
}

}  // namespace pliant
