#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// A field of a simulation at its last frame, by colour.
struct FieldPicture {
  std::string name;  ///< of the field
  std::string png;   ///< bytes of the file
};

/// Pictures for the report on a simulation; whoever can draw makes them.
struct SimulationPictures {
  std::string motion = {};  ///< bytes of a PNG file: frames side by side; empty: none
  std::vector<FieldPicture> fields = {};
  std::string missing = {};  ///< why there are none, a sentence; empty: nothing is missing
};

/// The report on the results of `pliant simulate`: one self-contained HTML file, like
/// `make_report`.
/// @param results_directory  holds simulation.json and the energies it names
/// @throws InputError where a results file is missing or not what its format says
std::string make_simulation_report(const std::filesystem::path& results_directory,
                                   const SimulationPictures& pictures);

}  // namespace pliant
