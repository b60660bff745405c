#pragma once

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "report/sample_results.h"

namespace pliant::testing {

/// A results directory as `pliant simulate` writes it, less its frames.
struct SampleSimulation {
  std::string name = "curtain";
  std::string warning = {};
  bool finished = true;
  bool energy = true;
  bool statistics = true;
  std::string method =
      R"({"kind": "dynamic", "integrator": "bdf2", "solve": "converged", "tolerance": 1e-5,
 "linear_tolerance": null, "adaptive": false, "friction": "variational"})";
  int most_substeps = 1;
  std::string crossing_pairs = "null";
  std::string contacts = "null";
  std::string contact_distance = "null";
  std::string way_tests = "null";
  double drag = 0;  ///< J, in the last frame
};

inline void write_sample_simulation(const std::filesystem::path& directory,
                                    const SampleSimulation& sample = {}) {
  constexpr int kFrames = 20;
  std::string frames, energy = "time_s,kinetic_J,stored_J,work_J,total_J,drag_J\n";
  for (int i = 0; i < kFrames; ++i) {
    frames += fmt::format("{}{{\"index\": {}, \"time\": {}}}", i == 0 ? "" : ", ", i, 0.01 * i);
    const double stored = 5 - 0.02 * i, work = 0.01 * i;
    energy += fmt::format("{},{},{},{},{},{}\n", 0.01 * i, 0.005 * i, stored, work,
                          stored + work + 0.005 * i, i + 1 < kFrames ? 0 : sample.drag);
  }
  const std::string numbers =
      sample.statistics ? R"({"min": 1, "median": 3, "mean": 3.25, "max": 9})" : "null";
  const std::string phases =
      sample.statistics
          ? R"({"assembly": {"min": 0.001, "median": 0.002, "mean": 0.002, "max": 0.003},
 "equations": null, "energies": null,
 "pairs": {"min": 0, "median": 0.001, "mean": 0.001, "max": 0.002},
 "ways": {"min": 0.001, "median": 0.002, "mean": 0.002, "max": 0.003}, "history": null})"
          : "null";
  const std::string seconds =
      sample.statistics ? R"({"min": 0.011, "median": 0.0125, "mean": 0.014, "max": 0.052})"
                        : "null";
  write_text(
      directory / "simulation.json",
      fmt::format(
          R"({{"pliant": "simulation/1", "name": "{}", "info": {{"lot": "A7"}},
 "command": "pliant simulate curtain.yaml -o out", "created": "2024-01-01T00:00:00Z",
 "version": "0.1.0", "scene": "scenes/curtain.yaml", "scene_sha256": "e3b0", "threads": 2,
 "finished": {}, "triangles": 4800, "vertices": 2501, "steps": 40, "time_step": 0.005,
 "method": {}, "frames": [{}], "seconds_per_step": {}, "seconds_by_phase": {},
 "substeps": {{"min": 1, "median": 1, "mean": 1.5, "max": {}}}, "newton_iterations": {}, "linear_iterations": {},
 "peak_memory_MB": 96, "not_modelled": ["contact", "drag of the air"], "crossing_pairs": {}, "contacts": {}, "contact_distance": {}, "way_tests": {}, "min_contact_distance": null, "energy": {}, "warnings": [{}]}})",
          sample.name, sample.finished, sample.method, frames, seconds, phases,
          sample.most_substeps, numbers, numbers, sample.crossing_pairs, sample.contacts,
          sample.contact_distance, sample.way_tests, sample.energy ? "\"energy.csv\"" : "null",
          sample.warning.empty() ? "" : "\"" + sample.warning + "\""));
  if (sample.energy) write_text(directory / "energy.csv", energy);
}

}  // namespace pliant::testing
