#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pliant::report {

/// Of a number over all steps; null where the file has none.
struct StepStatistics {
  std::optional<double> min, median, mean, max;
};

/// Where the energy of the system was, one number a frame: energy.csv.
struct EnergyTable {
  std::vector<double> time;     ///< s
  std::vector<double> kinetic;  ///< J
  std::vector<double> stored;   ///< J, elastic and of gravity
  std::vector<double> work;     ///< J, lost to friction, damping and air since the start
  std::vector<double> drag;     ///< J, of it to the air; 0 where the file does not say
  std::vector<double> outside;  ///< J, done by what is moved since the start; likewise

  std::size_t rows() const { return time.size(); }
};

/// How the steps were computed, in the words of scene/1; empty where the file does not say.
struct SimulationMethod {
  std::string kind, integrator, solve, friction;
  std::optional<double> tolerance;         ///< N, of converged steps
  std::optional<double> motion_tolerance;  ///< m, of iterated steps
  std::optional<double> linear_tolerance;  ///< relative, of linearized steps
  bool adaptive = false;
};

/// The method in one line, without the length of the step.
std::string method_text(const SimulationMethod& method);

struct SimulationResults;

/// What was not modelled, and whether triangles pass through each other in the end; empty where the
/// file says neither.
std::string limits_text(const SimulationResults& results);

/// simulation.json of a results directory, and its energies.
struct SimulationResults {
  std::string name, command, created, version, scene, scene_sha256;
  std::vector<std::pair<std::string, std::string>> info;
  bool finished = true;
  int triangles = 0, vertices = 0, steps = 0, threads = 0;
  double time_step = 0;  ///< s
  SimulationMethod method;
  std::size_t frames = 0;
  double last_time = 0;  ///< s, of the last frame
  StepStatistics seconds, substeps, newton_iterations, linear_iterations;
  StepStatistics contacts;          ///< what touches at the end of a step; none without contact
  StepStatistics contact_distance;  ///< least one at the end of a step (m); likewise
  StepStatistics way_tests;         ///< for what is met on them, in a step; likewise
  std::vector<std::pair<std::string, StepStatistics>> phases;  ///< of the seconds, in words
  std::optional<double> peak_memory;                           ///< MB
  std::optional<double> min_contact_distance;                  ///< m
  std::vector<std::string> not_modelled;  ///< what real cloth does and this one does not
  std::optional<int> crossing_pairs;      ///< of triangles that pass through each other in the end
  std::string energy_file;                ///< relative to the directory; empty: none
  EnergyTable energy;
  std::vector<std::string> warnings;
};

/// @throws InputError where a file is missing or not what its format says
SimulationResults read_simulation_results(const std::filesystem::path& directory);

}  // namespace pliant::report
