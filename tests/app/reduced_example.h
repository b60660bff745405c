#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/io/csv.h"
#include "pliant/io/ply.h"

#include "app/scene_folder.h"

namespace pliant::test {

inline const TextEdit kSmallSleeve{"nodes: 56x46", "nodes: 28x24"};

/// What makes an example small enough for a test.
inline const std::map<std::string, std::vector<TextEdit>> kReductions{
    {"step-29k", {{"nodes: 121x121", "nodes: 13x13"}}},
    {"hanging-sheet", {{"nodes: 25x25", "nodes: 9x9"}, {"steps: 20", "steps: 5"}}},
    {"curtain", {{"nodes: 51x41", "nodes: 17x13"}}},
    {"curtain-elastic", {{"nodes: 51x41", "nodes: 17x13"}}},
    {"drape-sphere", {{"nodes: 121x121", "nodes: 31x31"}, {"thickness: 1 mm", "thickness: 3 mm"}}},
    {"drop-20k", {{"nodes: 101x101", "nodes: 13x13"}}},
    {"cylinder-strip", {}},
    {"hanging-weights", {{"nodes: 21x21", "nodes: 5x5"}}},
    {"rubber-bar", {{"cells: [20, 4, 4]", "cells: [10, 2, 2]"}}}};

/// The same of those that friction_scenes_test.cpp runs.
inline const std::map<std::string, std::vector<TextEdit>> kFrictionReductions{
    {"twist-cotton", {kSmallSleeve}},
    {"twist-doublecloth", {kSmallSleeve}},
    {"twist-history", {kSmallSleeve}},
    {"settling", {kSmallSleeve}},
    {"preferred-wrinkle", {{"nodes: 31x61", "nodes: 15x29"}}}};

/// An example that was run at reduced size, without the report, whose pictures take longer.
class ReducedExample {
 public:
  explicit ReducedExample(const std::string& name, const std::vector<TextEdit>& more = {},
                          const std::vector<std::string>& arguments = {"--no-report"}) {
    const auto found = kReductions.find(name);
    std::vector<TextEdit> edits =
        found != kReductions.end() ? found->second : kFrictionReductions.at(name);
    edits.insert(edits.end(), more.begin(), more.end());
    folder_.copy_example(name, edits);
    run = folder_.simulate(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    result =
        nlohmann::json::parse(content_of(folder_.results() / "simulation.json"), nullptr, false);
  }

  /// One vertex a column (m).
  Eigen::Matrix3Xd frame(size_t index) const {
    const PlyMesh mesh = read_ply(folder_.results() / fmt::format("frames/{:06}.ply", index));
    return Eigen::Map<const Eigen::Matrix3Xd>(mesh.positions.front().data(), 3,
                                              std::ssize(mesh.positions));
  }
  Eigen::Matrix3Xd last_frame() const { return frame(result["frames"].size() - 1); }
  std::vector<double> energies(const char* column) const {
    return read_csv(folder_.results() / "energy.csv").numbers(column);
  }

  std::string results() const { return folder_.results().string(); }

  ProgramRun run;
  nlohmann::json result;

 private:
  SceneFolder folder_;
};

}  // namespace pliant::test
