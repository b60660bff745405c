#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/scene/simulation.h"

namespace pliant {

/// How a simulation was run, beside what the scene says.
struct SimulationFacts {
  std::string command;
  std::string created;  ///< UTC, ISO 8601
  std::string version;
  std::string scene_sha256;
  int threads = 1;
  std::optional<double> peak_memory;  ///< MB
};

/// Of a number over all steps; nothing where there was none.
struct StepStatistics {
  std::optional<double> min, median, mean, max;
};

/// How the steps were computed, in the words of scene/1; empty where the file does not say.
struct SimulationMethod {
  std::string kind, integrator, solve, friction;
  std::optional<double> tolerance;         ///< N, of converged steps
  std::optional<double> motion_tolerance;  ///< m, of iterated steps
  std::optional<double> linear_tolerance;  ///< relative, of linearized steps
  bool adaptive = false;
};

/// What a simulation did: simulation.json (docs/formats/simulation.md). Names of files are relative
/// to its directory, and empty where there is none.
struct SimulationResult {
  std::string name;
  std::map<std::string, std::string> info;
  SimulationFacts facts;
  std::string scene;  ///< file
  bool finished = true;
  int triangles = 0, vertices = 0, elements = 0, steps = 0;
  double time_step = 0;  ///< s
  SimulationMethod method;
  std::vector<double> frame_times;            ///< s
  std::map<std::string, std::string> fields;  ///< of frames: name and unit
  StepStatistics seconds, substeps, newton_iterations, linear_iterations;
  std::vector<std::pair<std::string, StepStatistics>> phases;  ///< of the seconds
  std::vector<std::string> not_modelled;  ///< what real cloth does and this one does not
  std::optional<int> crossing_pairs;      ///< of triangles that pass through each other in the end
  StepStatistics contacts;                ///< what touches at the end of a step
  StepStatistics contact_distance;        ///< least one at the end of a step (m)
  StepStatistics way_tests;               ///< for what is met on them, in a step
  std::optional<double> min_contact_distance;  ///< m
  std::string mesh, obstacles, solids, energy, clips;
  std::vector<std::string> warnings;

  double last_time() const { return frame_times.empty() ? 0 : frame_times.back(); }
};

SimulationResult simulation_result(const Simulation& simulation, const SimulationFacts& facts);

/// The text of simulation.json.
std::string simulation_text(const SimulationResult& result);

/// Reads `directory`/simulation.json.
/// @throws InputError where it is missing or not what its format says
SimulationResult read_simulation_result(const std::filesystem::path& directory);

/// The method in one line, without the length of the step.
std::string method_text(const SimulationMethod& method);

/// What was not modelled, and whether triangles pass through each other in the end; empty where the
/// file says neither.
std::string limits_text(const SimulationResult& result);

}  // namespace pliant
