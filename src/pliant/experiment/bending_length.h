#pragma once

#include <numbers>
#include <optional>

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

/// The overhang at which the line from the edge to the tip of a strip dips by an angle. The strip
/// starts flat and free of friction, and bends under its own weight once; with friction it reads
/// stiffer than its elasticity alone.
/// @param area_density  kg/m^2, > 0
/// @param angle         rad, in (0, pi/2)
/// @return nothing when no overhang below 10 m reaches the angle, or none has an equilibrium there
std::optional<BendingLength> bending_length(const ComponentLaw& law, double area_density,
                                            double angle = kOverhangAngle);

}  // namespace pliant
