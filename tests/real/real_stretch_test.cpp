// The stretch test of a real fabric in space; skipped where PLIANT_TEST_DATA does not hold its
// measurements.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/experiment/tensile/strip_pull.h"
#include "pliant/io/csv.h"
#include "pliant/material/material_file.h"

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

/// The rows of a clip in clips.csv.
struct ClipPath {
  std::vector<double> lengths;  ///< of the strip, m
  std::vector<double> forces;   ///< N
};

ClipPath path_of(const std::filesystem::path& file, const std::string& clip, double rest_length) {
  const CsvTable table = read_csv(file);
  const std::vector<std::string> clips = table.texts("clip");
  const std::vector<double> shifts = table.numbers("tz"), forces = table.numbers("fz");
  ClipPath path;
  for (size_t i = 0; i < clips.size(); ++i) {
    if (clips[i] != clip) continue;
    path.lengths.push_back(rest_length + shifts[i]);
    path.forces.push_back(forces[i]);
  }
  return path;
}

/// The half cycles of a path that turns at samples.
std::vector<HalfCycle> half_cycles_in(const std::vector<double>& path) {
  std::vector<HalfCycle> half_cycles;
  int first = 0;
  for (int i = 1; i < static_cast<int>(path.size()); ++i) {
    const auto at = [&](int sample) { return path[static_cast<size_t>(sample)]; };
    const bool last = i + 1 == static_cast<int>(path.size());
    const int direction = at(i) > at(i - 1) ? 1 : -1;
    if (!last && (at(i + 1) - at(i)) * direction > 0) continue;
    half_cycles.push_back({first, i, direction, at(i)});
    first = i + 1;
  }
  return half_cycles;
}

// The loops of examples/fab-stretch.yaml.
TEST(RealFabInSpace, PullsAtItsClipAsTheOneDimensionalModelPredicts) {
  const char* data = std::getenv("PLIANT_TEST_DATA");
  const auto record = std::filesystem::path(data == nullptr ? "" : data) /
                      "cloth_hysteresis_fab/fab_knit_cotton_300gsm.json";
  if (!std::filesystem::exists(record)) GTEST_SKIP() << "PLIANT_TEST_DATA does not hold " << record;

  const SceneFolder folder;
  const auto fit = folder.path() / "fab-fit";
  ASSERT_EQ(run_program({"fit", record.string(), "-o", fit.string()}).status, 0);
  folder.copy_example("fab-stretch", {{"nodes: 25x25", "nodes: 9x9"}});
  const ProgramRun run = folder.simulate();
  ASSERT_EQ(run.status, 0) << run.err;

  constexpr double kLength = 0.08, kWidth = 0.04;
  const ClipPath path = path_of(folder.results() / "clips.csv", "moving", kLength);
  const Material material = read_material(fit / "material.json");
  const auto predicted =
      pull_strip(*law_of(material, "stretch.warp"), {kLength, kWidth, material.membrane}, {}, {},
                 path.lengths, half_cycles_in(path.lengths), 0);
  ASSERT_TRUE(predicted);
  const double peak = *std::max_element(path.forces.begin(), path.forces.end());
  double largest = 0;
  for (size_t i = 0; i < path.forces.size(); ++i) {
    const double difference =
        std::abs(path.forces[i] - predicted->force(static_cast<Eigen::Index>(i)));
    largest = std::max(largest, difference);
  }
  fmt::print("cotton knit in space: {} equilibria, peak {:.3f} N, largest difference {:.1e} N\n",
             path.forces.size(), peak, largest);
  EXPECT_GT(peak, 1);
  // 10 uN are left at each of the clip's nine nodes.
  EXPECT_LT(largest, 9 * 1e-5);
}

}  // namespace
}  // namespace pliant::test
