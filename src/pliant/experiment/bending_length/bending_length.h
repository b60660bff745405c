#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "pliant/io/fields.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// What the overhang test (ASTM D1388 option A, ISO 9073-7) says of a sheet.
struct BendingLength {
  double overhang = 0;           ///< length whose tip is seen at the angle from the edge (m)
  double length = 0;             ///< c, the bending length: half of the overhang (m)
  double flexural_rigidity = 0;  ///< G = weight per area c^3 (N m, per width)
};

/// Inclination of the instrument's guide lines: there the overhang of an elastic strip of rigidity
/// B and weight w per area is 2.0003 (B / w)^(1/3), so that its half is Peirce's bending length.
inline constexpr double kOverhangAngle = 41.5 * std::numbers::pi / 180;

/// Reads `angle:`, by default that of the guide lines.
/// @throws InputError unless it lies between 0 and 90 degrees
double read_overhang_angle(Fields& fields);

/// The overhang at which the line from the edge to the tip of a strip dips by an angle. The strip
/// starts flat and free of friction, and bends under its own weight once; with friction it reads
/// stiffer than its elasticity alone.
/// @param area_density  kg/m^2, > 0
/// @param angle         rad, in (0, pi/2)
/// @return nothing when no overhang below 10 m reaches the angle, or none has an equilibrium there
std::optional<BendingLength> bending_length(const ComponentLaw& law, double area_density,
                                            double angle = kOverhangAngle);

/// A strip without friction and of one rigidity B, at the overhang that dips by an angle. Lengths
/// count in (B / weight)^(1/3), its bending length.
struct ElasticDip {
  double overhang_per_length = 0;  ///< about 2 at 41.5 degrees
  double edge_turn = 0;            ///< curvature where it leaves the edge, times the overhang
};

/// @param angle  rad, in (0, pi/2)
/// @return nothing within a hair of pi/2, where the overhang is hundreds of bending lengths
std::optional<ElasticDip> elastic_dip(double angle);

/// What the standards report of several readings.
struct BendingLengthSpread {
  int readings = 0;
  double length = 0;                         ///< mean bending length (m)
  std::optional<double> length_variation;    ///< its coefficient of variation between readings
  double flexural_rigidity = 0;              ///< of the mean length (N m); 0 without a weight
  std::optional<double> rigidity_variation;  ///< coefficient of variation of the readings' own
};

/// @param overhangs  m, at least one, > 0
/// @param weight     per area (N/m^2)
/// @return nothing for an angle that `elastic_dip` has nothing for
std::optional<BendingLengthSpread> bending_length_spread(const std::vector<double>& overhangs,
                                                         double angle, double weight);

}  // namespace pliant
