#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

inline constexpr double kStandardGravity = 9.80665;  ///< m/s^2, by definition

/// What a quantity measures; its SI unit is behind each.
enum class Dimension {
  number,             ///< no unit at all
  length,             ///< m
  mass,               ///< kg
  force,              ///< N; also a moment per width
  time,               ///< s
  angle,              ///< rad
  area,               ///< m^2
  area_density,       ///< kg/m^2
  force_per_length,   ///< N/m: membrane stiffness and stress
  bending_stiffness,  ///< N m: moment per width and curvature
  curvature,          ///< 1/m
  stress,             ///< Pa
  volume_density,     ///< kg/m^3
  temperature,        ///< K
  frequency,          ///< 1/s
  compliance,         ///< m/N: how far something gives way to a force
  fraction,           ///< 1; written in percent
};

/// A text is no quantity of the dimension asked for.
class QuantityError : public std::invalid_argument {
 public:
  QuantityError(std::string problem, std::string expected);

  const std::string& problem() const { return problem_; }
  const std::string& expected() const { return expected_; }

 private:
  std::string problem_;
  std::string expected_;
};

/// SI value = scale * value + offset.
struct UnitConversion {
  double scale = 1.0;
  double offset = 0.0;

  double to_si(double value) const { return scale * value + offset; }
};

/// "100 mm" or "100mm" -> 0.1: a finite number (decimal point) and a unit of `dimension`, in SI.
/// `Dimension::number` takes a bare number; every other dimension needs its unit.
/// @throws QuantityError naming the units accepted
double parse_quantity(std::string_view text, Dimension dimension);

/// The conversion of a unit in any spelling: "N/m", "N_per_m", "kg/m2", "MM"; MN is never mN.
std::optional<UnitConversion> unit_conversion(std::string_view unit, Dimension dimension);

/// The factor to SI of a unit; none for an unknown unit and for one with an offset (degC).
std::optional<double> unit_scale(std::string_view unit, Dimension dimension);

/// Whether `unit` is a unit of any dimension.
bool is_unit(std::string_view unit);

/// "force per length", as in an error message.
std::string dimension_name(Dimension dimension);

/// The SI unit as written in results, e.g. "N/m"; empty for numbers and fractions.
std::string si_unit(Dimension dimension);

/// The accepted units in their usual spelling, the SI unit first where it is accepted.
std::vector<std::string> units_of(Dimension dimension);

/// The accepted units in one phrase for an error message: "a force with its unit: N, mN, ...".
std::string expected_quantity(Dimension dimension);

/// An SI value in a unit that reads well, e.g. 0.1 m -> "100 mm", with `digits` significant digits.
std::string format_quantity(double si, Dimension dimension, int digits);

/// The same with 4 significant digits.
std::string format_quantity(double si, Dimension dimension);

/// An SI value in the SI unit, with the digits that read back to the same number: "0.1 m".
std::string exact_quantity(double si, Dimension dimension);

}  // namespace pliant
