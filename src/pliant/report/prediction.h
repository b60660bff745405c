#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::report {

enum class Branch { load, unload, rest };

/// One experiment, row by row: what was measured and what the material predicts
/// (predictions/EXPERIMENT.csv). All non-empty lists have the same length.
struct Prediction {
  std::vector<std::string> specimen;
  std::vector<double> strain;
  std::vector<Branch> branch;
  std::vector<char> used;  ///< 1: the row took part in the fit or comparison
  std::vector<double> measured;
  std::vector<double> predicted;  ///< NaN where there is no prediction
  std::vector<double> elastic;    ///< best purely elastic curve; empty where there is none
  std::vector<double> low, high;  ///< 95 % band of `predicted`; empty where not known
  std::vector<double> time;       ///< s; empty where not recorded
  /// What drove the experiment, for the other axis of a loop: the load where lengths are measured,
  /// the angle where shear is; empty where the strain itself serves.
  std::vector<double> driver;
  std::string driver_column;

  std::size_t rows() const { return strain.size(); }
};

/// @param quantity  the measured quantity with its unit as in fit.json, e.g. `force_N`
/// @throws InputError where the file, a column or a number is not what the format says
Prediction read_prediction(const std::filesystem::path& file, std::string_view quantity);

}  // namespace pliant::report
