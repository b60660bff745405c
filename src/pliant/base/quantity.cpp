#include "pliant/base/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr double kGramForce = 1e-3 * kStandardGravity;
constexpr double kPound = 0.45359237;
constexpr double kPoundForce = kPound * kStandardGravity;
constexpr double kInch = 0.0254;
constexpr double kOunce = kPound / 16;
constexpr double kSquareYard = 0.9144 * 0.9144;
constexpr double kDegree = std::numbers::pi / 180;

enum Use : unsigned {
  kAccepted = 0,
  kAlias = 1,   // another spelling: accepted, but not offered in messages
  kPretty = 2,  // format_quantity may choose it
  // How testers' tables write a unit; documents write its symbol.
  kInTables = 4,
};

struct Unit {
  const char* name;
  double scale;
  unsigned use = kAccepted;
  double offset = 0.0;
};

// The first of each list is the SI unit, except for fractions.
constexpr Unit kLengths[] = {{"m", 1, kPretty},
                             {"cm", 1e-2},
                             {"mm", 1e-3, kPretty},
                             {"um", 1e-6, kPretty},
                             {"in", kInch},
                             {"inch", kInch, kAlias},
                             {"inches", kInch, kInTables},
                             {"millimeter", 1e-3, kInTables},
                             {"millimeters", 1e-3, kInTables},
                             {"millimetre", 1e-3, kInTables},
                             {"millimetres", 1e-3, kInTables},
                             {"centimeter", 1e-2, kInTables},
                             {"centimeters", 1e-2, kInTables},
                             {"centimetre", 1e-2, kInTables},
                             {"centimetres", 1e-2, kInTables},
                             {"meter", 1, kInTables},
                             {"meters", 1, kInTables},
                             {"metre", 1, kInTables},
                             {"metres", 1, kInTables}};
constexpr Unit kMasses[] = {{"kg", 1, kPretty},
                            {"g", 1e-3, kPretty},
                            {"mg", 1e-6, kPretty},
                            {"lb", kPound},
                            {"oz", kOunce}};
constexpr Unit kForces[] = {{"N", 1, kPretty},
                            {"kN", 1e3},
                            {"mN", 1e-3, kPretty},
                            {"cN", 1e-2},
                            {"uN", 1e-6, kPretty},
                            {"gf", kGramForce},
                            {"kgf", kStandardGravity},
                            {"lbf", kPoundForce},
                            {"newton", 1, kInTables},
                            {"newtons", 1, kInTables},
                            {"kilonewton", 1e3, kInTables},
                            {"lb", kPoundForce, kInTables},
                            {"lbs", kPoundForce, kInTables},
                            {"N m/m", 1, kAlias},
                            {"gf cm/cm", kGramForce, kAlias}};
constexpr Unit kTimes[] = {{"s", 1, kPretty},
                           {"ms", 1e-3, kPretty},
                           {"us", 1e-6},
                           {"min", 60},
                           {"h", 3600},
                           {"sec", 1, kAlias},
                           {"Sec", 1, kAlias},
                           {"sec.", 1, kInTables},
                           {"secs", 1, kInTables},
                           {"second", 1, kInTables},
                           {"seconds", 1, kInTables},
                           {"minutes", 60, kInTables}};
constexpr Unit kAngles[] = {{"rad", 1},
                            {"deg", kDegree, kPretty},
                            {"degree", kDegree, kInTables},
                            {"degrees", kDegree, kInTables}};
constexpr Unit kAreas[] = {{"m^2", 1, kPretty}, {"cm^2", 1e-4, kPretty}, {"mm^2", 1e-6, kPretty}};
constexpr Unit kAreaDensities[] = {{"kg/m^2", 1},
                                   {"g/m^2", 1e-3, kPretty},
                                   {"gsm", 1e-3},
                                   {"g/cm^2", 10},
                                   {"oz/yd^2", kOunce / kSquareYard}};
constexpr Unit kForcesPerLength[] = {{"N/m", 1, kPretty},
                                     {"N/cm", 1e2},
                                     {"N/mm", 1e3},
                                     {"kN/m", 1e3},
                                     {"mN/m", 1e-3},
                                     {"cN/cm", 1},
                                     {"gf/cm", 1e2 * kGramForce},
                                     {"kgf/cm", 1e2 * kStandardGravity},
                                     {"lbf/in", kPoundForce / kInch}};
constexpr Unit kBendingStiffnesses[] = {{"N m", 1, kPretty},
                                        {"mN m", 1e-3, kPretty},
                                        {"uN m", 1e-6, kPretty},
                                        {"nN m", 1e-9, kPretty},
                                        {"N mm", 1e-3},
                                        {"mN mm", 1e-6},
                                        {"mN cm", 1e-5},
                                        {"cN cm", 1e-4},
                                        {"gf cm", 1e-2 * kGramForce},
                                        {"Nm", 1, kAlias},
                                        {"mNm", 1e-3, kAlias},
                                        {"N m^2/m", 1, kAlias},
                                        {"gf cm^2/cm", 1e-2 * kGramForce}};
constexpr Unit kCurvatures[] = {{"1/m", 1, kPretty},    {"1/cm", 1e2},
                                {"1/mm", 1e3},          {"m^-1", 1, kAlias},
                                {"cm^-1", 1e2, kAlias}, {"mm^-1", 1e3, kAlias}};
constexpr Unit kStresses[] = {{"Pa", 1, kPretty},
                              {"GPa", 1e9},
                              {"MPa", 1e6, kPretty},
                              {"kPa", 1e3, kPretty},
                              {"N/mm^2", 1e6},
                              {"N/m^2", 1, kAlias},
                              {"psi", kPoundForce / (kInch * kInch)}};
constexpr Unit kVolumeDensities[] = {{"kg/m^3", 1, kPretty}, {"g/cm^3", 1e3}};
constexpr Unit kTemperatures[] = {{"K", 1},
                                  {"degC", 1, kPretty, 273.15},
                                  {"C", 1, kAlias, 273.15},
                                  {"degF", 5.0 / 9, kAccepted, 273.15 - 32 * 5.0 / 9}};
constexpr Unit kFrequencies[] = {{"Hz", 1, kPretty}};
constexpr Unit kCompliances[] = {{"m/N", 1}, {"mm/N", 1e-3, kPretty}, {"um/N", 1e-6, kPretty}};
constexpr Unit kFractions[] = {
    {"%", 1e-2, kPretty}, {"percent", 1e-2}, {"mm/mm", 1, kAlias}, {"in/in", 1, kAlias}};

struct DimensionEntry {
  const char* name;
  const char* article;
  const char* si_unit;
  std::span<const Unit> units;
};

const DimensionEntry& entry_of(Dimension dimension) {
  static const DimensionEntry kEntries[] = {
      {"number", "a", "", {}},
      {"length", "a", "m", kLengths},
      {"mass", "a", "kg", kMasses},
      {"force", "a", "N", kForces},
      {"time", "a", "s", kTimes},
      {"angle", "an", "rad", kAngles},
      {"area", "an", "m^2", kAreas},
      {"mass per area", "a", "kg/m^2", kAreaDensities},
      {"force per length", "a", "N/m", kForcesPerLength},
      {"bending stiffness", "a", "N m", kBendingStiffnesses},
      {"curvature", "a", "1/m", kCurvatures},
      {"stress", "a", "Pa", kStresses},
      {"mass per volume", "a", "kg/m^3", kVolumeDensities},
      {"temperature", "a", "K", kTemperatures},
      {"frequency", "a", "Hz", kFrequencies},
      {"compliance", "a", "m/N", kCompliances},
      {"fraction", "a", "", kFractions},
  };
  const auto index = static_cast<std::size_t>(dimension);
  PLIANT_ASSERT(index < std::size(kEntries), "not a dimension");
  return kEntries[index];
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
}

/// One form for the spellings of a unit: "N_per_m" and "N / m" become "N/m", "kg/m²" and "kg/m^2"
/// become "kg/m2", "N*m", "N·m", "N.m" and "N_m" become "N m", "°C" becomes "degC".
std::string canonical(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kSpellings = {{
      {"_per_", "/"},
      {"\u00b5", "u"},  // micro sign
      {"\u03bc", "u"},  // Greek mu
      {"\u00b0", "deg"},
      {"\u00b2", "2"},
      {"\u00b3", "3"},
      {"\u207b\u00b9", "-1"},
      {"\u00b7", " "},
      {".", " "},
      {"\u2103", "degC"},
      {"^", ""},
      {"*", " "},
      {"_", " "},
      {" /", "/"},
      {"/ ", "/"},
  }};
  std::string result(trimmed(unit));
  for (const auto& [from, to] : kSpellings) replace_all(result, from, to);
  return result;
}

/// Whether a text is a unit in letters of another case, which leave no doubt: MN is not mN, mPa not
/// MPa, and M alone may be a moment.
bool is_unit_in_other_case(std::string_view text, std::string_view unit) {
  if (!same_letters(text, unit) || text == "M") return false;
  const bool has_prefix =
      unit.size() > 1 && (unit[0] == 'm' || unit[0] == 'M') && (unit[1] == 'N' || unit[1] == 'P');
  return !has_prefix || text[0] == unit[0] || text == lower_case(text);
}

/// The first unit of a dimension of which `is_meant` holds.
template <class IsMeant>
std::optional<UnitConversion> find_unit(Dimension dimension, IsMeant is_meant) {
  const auto units = entry_of(dimension).units;
  const auto found = std::ranges::find_if(units, is_meant);
  return found == units.end() ? std::nullopt
                              : std::optional(UnitConversion{found->scale, found->offset});
}

/// As documents write units: by their symbols.
std::optional<UnitConversion> unit_by_symbol(std::string_view text, Dimension dimension) {
  const std::string spelling = canonical(text);
  return find_unit(dimension, [&](const Unit& unit) {
    return (unit.use & kInTables) == 0 && canonical(unit.name) == spelling;
  });
}

/// Size of the number at the start of `text`.
std::size_t number_size(std::string_view text) {
  const auto digits = [&](std::size_t at) {
    while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
    return at;
  };
  std::size_t end = digits(!text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0);
  if (end < text.size() && text[end] == '.') end = digits(end + 1);
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t first = end + (sign ? 2 : 1);
    if (digits(first) > first) end = digits(first);
  }
  return end;
}

/// The largest readable unit that leaves at least 1 before the decimal point, or the smallest.
const Unit& readable_unit(double si, std::span<const Unit> units) {
  const Unit* smallest = nullptr;
  const Unit* fitting = nullptr;
  for (const Unit& unit : units) {
    if ((unit.use & kPretty) == 0) continue;
    if (smallest == nullptr || unit.scale < smallest->scale) smallest = &unit;
    if (unit.scale > std::abs(si)) continue;
    if (fitting == nullptr || unit.scale > fitting->scale) fitting = &unit;
  }
  PLIANT_ASSERT(smallest != nullptr, "every dimension has a readable unit");
  return fitting != nullptr ? *fitting : *smallest;
}

double parse_bare_number(std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value) throw QuantityError(quoted_value(text) + " is not a finite number", "a number");
  return *value;
}

}  // namespace

QuantityError::QuantityError(std::string problem, std::string expected)
    : std::invalid_argument(problem + "; expected " + expected),
      problem_(std::move(problem)),
      expected_(std::move(expected)) {}

double parse_quantity(std::string_view text, Dimension dimension) {
  text = trimmed(text);
  if (dimension == Dimension::number) return parse_bare_number(text);
  const std::string expected = expected_quantity(dimension);
  const std::size_t size = number_size(text);
  const std::optional<double> value = parse_number(text.substr(0, size));
  const std::string_view unit = trimmed(text.substr(size));
  if (!value)
    throw QuantityError(quoted_value(text) + " is not a finite number with a unit", expected);
  if (unit.empty()) throw QuantityError(quoted_value(text) + " has no unit", expected);
  if (unit.front() == ',') {
    throw QuantityError(quoted_value(text) + " has a decimal comma",
                        expected + " and a decimal point");
  }
  const std::optional<UnitConversion> conversion = unit_by_symbol(unit, dimension);
  if (!conversion) {
    throw QuantityError(fmt::format("{}: {} is no unit of {}", quoted_value(text),
                                    quoted_value(unit), dimension_name(dimension)),
                        expected);
  }
  const double si = conversion->to_si(*value);
  if (!std::isfinite(si)) throw QuantityError(quoted_value(text) + " is too large", expected);
  return si;
}

std::optional<UnitConversion> unit_conversion(std::string_view unit, Dimension dimension) {
  if (const auto by_symbol = unit_by_symbol(unit, dimension)) return by_symbol;
  const std::string spelling = canonical(unit);
  return find_unit(dimension, [&](const Unit& known) {
    return is_unit_in_other_case(spelling, canonical(known.name));
  });
}

std::optional<double> unit_scale(std::string_view unit, Dimension dimension) {
  const std::optional<UnitConversion> conversion = unit_conversion(unit, dimension);
  if (!conversion || conversion->offset != 0.0) return std::nullopt;
  return conversion->scale;
}

bool is_unit(std::string_view unit) {
  for (int i = 0; i <= static_cast<int>(Dimension::fraction); ++i) {
    if (unit_conversion(unit, static_cast<Dimension>(i))) return true;
  }
  return false;
}

std::string dimension_name(Dimension dimension) { return entry_of(dimension).name; }

std::string si_unit(Dimension dimension) { return entry_of(dimension).si_unit; }

std::vector<std::string> units_of(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : entry_of(dimension).units) {
    if ((unit.use & (kAlias | kInTables)) == 0) names.emplace_back(unit.name);
  }
  return names;
}

std::string expected_quantity(Dimension dimension) {
  const DimensionEntry& entry = entry_of(dimension);
  if (entry.units.empty()) return "a number";
  return fmt::format("{} {} with its unit ({})", entry.article, entry.name,
                     fmt::join(units_of(dimension), ", "));
}

std::string format_quantity(double si, Dimension dimension, int digits) {
  const std::span<const Unit> units = entry_of(dimension).units;
  if (units.empty()) return format_number(si, digits);
  // The unit is that of what is shown: 0.99999 m^2 are 1 m^2, not 1e+04 cm^2.
  const double shown = parse_number(format_number(si, digits)).value_or(si);
  const Unit& unit = si == 0.0 ? units.front() : readable_unit(shown, units);
  return fmt::format("{} {}", format_number((si - unit.offset) / unit.scale, digits), unit.name);
}

std::string format_quantity(double si, Dimension dimension) {
  return format_quantity(si, dimension, 4);
}

std::string exact_quantity(double si, Dimension dimension) {
  return format_number(si) + " " + si_unit(dimension);
}

}  // namespace pliant
