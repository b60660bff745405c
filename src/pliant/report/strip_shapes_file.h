#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant::report {

/// Points of a profile, or of a path of bending; lists of one length, in the units of the file. NaN
/// where there is no such number.
struct ShapeLine {
  double setting_mm = 0;  ///< radius of the cylinder, or overhang
  std::vector<double> arc_length_mm, x_mm, y_mm, curvature, moment, distance_mm;
  std::vector<char> used;
};

/// The strips of an experiment (shapes/EXPERIMENT.csv).
struct StripShapes {
  std::string setting;               ///< `radius` or `overhang`
  std::vector<ShapeLine> measured;   ///< one a profile
  std::vector<ShapeLine> predicted;  ///< one for each setting
  std::vector<ShapeLine> bent;       ///< moment over curvature from flat to the cylinder and back

  /// The settings in the order of their size, each once.
  std::vector<double> settings() const;
};

/// @throws InputError where the file, a column or a number is not what the format says
StripShapes read_strip_shapes(const std::filesystem::path& file);

}  // namespace pliant::report
