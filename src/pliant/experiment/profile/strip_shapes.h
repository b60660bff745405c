#pragma once

#include <string>
#include <vector>

#include "pliant/material/component_law.h"

namespace pliant {

/// The profile of a strip: measured, a point a row, or predicted, as a dense line. Its lists have
/// one length.
struct ProfileLine {
  double setting = 0;              ///< what the test varies: overhang or radius (m)
  int first_row = 0;               ///< of a measured profile, whose rows follow one another
  std::vector<double> arc_length;  ///< from the clamp (m)
  std::vector<double> x, y;        ///< m; gravity along -y, clamp along +x
  std::vector<double> curvature;   ///< 1/m, positive where the profile turns left
  std::vector<double> moment;      ///< per width (N), of what hangs beyond the point
};

/// Moment per width over curvature of a point of a strip that is bent from flat and let go.
struct BendingPath {
  double setting = 0;             ///< m
  std::vector<double> curvature;  ///< 1/m
  std::vector<double> moment;     ///< N
};

/// How far a strip is bent on, all along together, to see whether it comes back (rad).
inline constexpr double kPushedBy = 1.5;

/// What there is to draw of strips whose profiles are measured.
struct StripShapes {
  std::string setting_name;            ///< overhang, radius
  std::vector<ProfileLine> measured;   ///< in the order of the data
  std::vector<ProfileLine> predicted;  ///< one for each setting and shape that profiles rest in
  std::vector<BendingPath> bent;       ///< one for each radius; empty where nothing was rolled
  std::vector<double> ambiguous;       ///< settings (m) whose strip, pushed, stays in another shape
  std::vector<double> elsewhere;       ///< those (m) of the profiles that rest in such a shape
};

/// The path of a material point from flat to a curvature and back to flat.
/// @param curvature  not zero (1/m)
BendingPath bent_and_released(const ComponentLaw& law, double setting, double curvature);

}  // namespace pliant
