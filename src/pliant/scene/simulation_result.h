#pragma once

#include <string>

#include "pliant/scene/simulation.h"

namespace pliant {

/// How a simulation was run, beside what the scene says.
struct SimulationFacts {
  std::string command;
  std::string created;  ///< UTC, ISO 8601
  std::string version;
  std::string scene_sha256;
  int threads = 1;
  double peak_memory = 0;  ///< MB
};

/// The text of simulation.json (docs/formats/simulation.md).
std::string simulation_text(const Simulation& simulation, const SimulationFacts& facts);

}  // namespace pliant
