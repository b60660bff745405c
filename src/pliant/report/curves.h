#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant::report {

/// The stress-strain curve of one material component, sampled over strain (curves.csv).
/// Stresses in N/m for membranes; all lists have the length of `strain`.
struct ComponentCurve {
  std::string component;
  std::vector<double> strain;
  std::vector<double> load, unload;  ///< loading and unloading branch
  std::vector<double> low, high;  ///< 95 % band of the loading branch; empty where unknown, as for
                                  ///< a material that was not fitted here
  std::vector<double> elastic;    ///< the part without friction; empty where not given
  std::vector<double> max_friction;  ///< half-width of the friction envelope; empty where not given
};

/// The curves of curves.csv in the order of their first rows.
std::vector<ComponentCurve> read_curves(const std::filesystem::path& file);

}  // namespace pliant::report
