// The examples that show what internal friction does ([T] 5.5), at reduced size, with it and
// without: the measured quantity tells the two apart, and nothing passes through anything.

#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include "app/reduced_example.h"
#include "support/asked_for.h"

namespace pliant::test {
namespace {

using nlohmann::json;

/// How far a frame is from another of the same run.
json difference(const ReducedExample& run, int frame, int with) {
  const ProgramRun compared =
      run_program({"compare", run.results(), "--to", std::to_string(with), "--json"});
  EXPECT_EQ(compared.status, 0) << compared.err;
  return json::parse(compared.out)["frames"].at(frame);
}

/// An example with internal friction and without, each of whose steps was tested exactly.
struct Pair {
  explicit Pair(const std::string& name, const std::vector<TextEdit>& edits = {})
      : rough(name, edits, {"--verify", "--no-report"}),
        elastic(name, edits, {"--verify", "--no-report", "--no-friction"}) {}

  ReducedExample rough, elastic;
};

struct Twist {
  std::string name, example;
  bool damped;
};

void PrintTo(const Twist& twist, std::ostream* out) { *out << twist.name; }

class SlowTwistedSleeve : public ::testing::TestWithParam<Twist> {};

// [T] Fig. 5.13. Without friction what is left is what the cylinder does to the flat cloth: it
// settles by a tenth of a millimetre from the circle it begins on.
TEST_P(SlowTwistedSleeve, StaysWrinkledWithFrictionAlone) {
  std::vector<TextEdit> edits;
  if (!GetParam().damped) edits.emplace_back("damping: {fraction: 0.02}\n", "");
  const Pair pair(GetParam().example, edits);
  const json rough = difference(pair.rough, 10, 0), elastic = difference(pair.elastic, 10, 0);
  EXPECT_GT(rough["distance"], 3 * elastic["distance"].get<double>());
  EXPECT_GT(rough["curvature"], 1.3 * elastic["curvature"].get<double>());
  EXPECT_LT(elastic["distance"], 3e-4);
}

/// One of each kind, and all four for the table.
std::vector<Twist> twists() {
  std::vector<Twist> twists{{"Cotton", "twist-cotton", true},
                            {"DoubleclothUndamped", "twist-doublecloth", false}};
  if (!makes_figures()) return twists;
  twists.push_back({"CottonUndamped", "twist-cotton", false});
  twists.push_back({"Doublecloth", "twist-doublecloth", true});
  return twists;
}

INSTANTIATE_TEST_SUITE_P(Of, SlowTwistedSleeve, ::testing::ValuesIn(twists()),
                         [](const auto& twist) { return twist.param.name; });

// [T] Fig. 5.14: frames 7, 14 and 21 stand after one, two and three cycles.
TEST(SlowFrictionScenes, WrinklesAfterEachCycleAreOthersWithFrictionAndRepeatWithout) {
  const Pair pair("twist-history");
  for (const auto& [frame, with] : {std::pair(14, 7), {21, 7}, {21, 14}}) {
    EXPECT_GT(difference(pair.rough, frame, with)["distance"], 2e-4) << frame << " " << with;
    EXPECT_LT(difference(pair.elastic, frame, with)["distance"], 1e-5) << frame << " " << with;
  }
}

// [T] Fig. 5.16: the twist is undone at 0.6 s; a frame stands each 20 ms.
TEST(SlowFrictionScenes, WrinklesSettleByFriction) {
  const Pair pair("settling");
  const auto late_motion = [](const ReducedExample& run) {
    constexpr size_t kFirst = 45;  // 0.9 s
    const std::vector<double> kinetic = run.energies("kinetic_J");
    double sum = 0;
    for (size_t i = kFirst; i < kinetic.size(); ++i) sum += kinetic[i];
    return sum;
  };
  EXPECT_GT(late_motion(pair.elastic), 5 * late_motion(pair.rough));
}

/// Where the sheet of preferred-wrinkle is highest on its way from bottom to top, at rest: the mean
/// of its columns (mm).
double place_of_ridge(const ReducedExample& run, size_t frame) {
  constexpr int kColumns = 15, kRows = 29;
  const Eigen::Matrix3Xd at = run.frame(frame);
  double sum = 0;
  for (int i = 0; i < kColumns; ++i) {
    Eigen::Index highest = 0;
    at.row(2)(Eigen::seqN(i, kRows, kColumns)).maxCoeff(&highest);
    sum += 200 * static_cast<double>(highest) / (kRows - 1);
  }
  return sum / kColumns;
}

/// A third time, at an angle of 14 degrees to the other side: from the top at 3.5 s, from the
/// bottom at 4.1 s.
const std::vector<TextEdit> kOnceMore{
    {"translate: [0.01, -0.02, 0]}\n        - {time: 2.6 s}",
     "translate: [0.01, -0.02, 0]}\n        - {time: 2.6 s}\n        - {time: 3.2 s}\n"
     "        - {time: 3.5 s, translate: [-0.005, -0.02, 0]}\n        - {time: 3.8 s}"},
    {"translate: [-0.01, 0.02, 0]}\n        - {time: 3.2 s}",
     "translate: [-0.01, 0.02, 0]}\n        - {time: 3.2 s}\n        - {time: 3.8 s}\n"
     "        - {time: 4.1 s, translate: [0.005, 0.02, 0]}"},
    {"duration: 3.2 s", "duration: 4.1 s"}};

// [T] Fig. 5.15: pushed from the top at 1.1 s and from the bottom at 1.7 s, and so again at two
// angles. The rod stretched its middle.
TEST(SlowFrictionScenes, AStretchedPlaceWrinklesFromWhicheverSideItIsPushed) {
  for (int seed = 1; seed <= (makes_figures() ? 5 : 1); ++seed) {
    std::vector<TextEdit> edits = kOnceMore;
    edits.emplace_back("seed: 1", fmt::format("seed: {}", seed));
    const Pair pair("preferred-wrinkle", edits);
    for (const auto& [from_bottom, from_top] : {std::pair(17, 11), {29, 23}, {41, 35}}) {
      const double rough = difference(pair.rough, from_bottom, from_top)["curvature"];
      EXPECT_GT(difference(pair.elastic, from_bottom, from_top)["curvature"], 5 * rough)
          << from_bottom;
      const double places[] = {place_of_ridge(pair.rough, size_t(from_top)),
                               place_of_ridge(pair.rough, size_t(from_bottom)),
                               place_of_ridge(pair.elastic, size_t(from_top)),
                               place_of_ridge(pair.elastic, size_t(from_bottom))};
      if (makes_figures()) {
        std::cout << fmt::format(
            "preferred-wrinkle, seed {}, frames {} and {}, ridge at {:.1f} and "
            "{:.1f} mm with friction, {:.1f} and {:.1f} mm without\n",
            seed, from_top, from_bottom, places[0], places[1], places[2], places[3]);
      }
      EXPECT_NEAR(places[0], 100, 5) << from_top;
      EXPECT_NEAR(places[1], 100, 5) << from_bottom;
      EXPECT_GT(places[2], 150) << from_top;
      EXPECT_LT(places[3], 50) << from_bottom;
    }
  }
}

/// How wrinkled the cloth of drape-sphere is when it begins to hang down (1/m).
double wrinkles_of_drape(int seed, bool friction) {
  std::vector<std::string> arguments{"--verify", "--no-report"};
  if (!friction) arguments.emplace_back("--no-friction");
  const ReducedExample run(
      "drape-sphere",
      {{"    place: {",
        fmt::format("    noise: {{amplitude: 1 um, seed: {}}}\n    place: {{", seed)},
       {"duration: 800 ms", "duration: 150 ms"}},
      arguments);
  return difference(run, 3, 0)["curvature"];
}

// How it lies in the end is chance, with friction and without.
TEST(SlowFrictionScenes, FrictionChangesHowADrapeBeginsToFoldByMoreThanChance) {
  std::vector<double> rough, elastic;
  for (int seed = 1; seed <= 5; ++seed) {
    rough.push_back(wrinkles_of_drape(seed, true));
    elastic.push_back(wrinkles_of_drape(seed, false));
  }
  const auto [least, most] = std::ranges::minmax(rough);
  const auto [least_elastic, most_elastic] = std::ranges::minmax(elastic);
  if (makes_figures()) {
    std::cout << fmt::format(
        "drape-sphere at 150 ms: {:.2f} to {:.2f} 1/m with friction, {:.2f} to "
        "{:.2f} without\n",
        least, most, least_elastic, most_elastic);
  }
  EXPECT_GT(least - most_elastic, 2 * std::max(most - least, most_elastic - least_elastic));
}

}  // namespace
}  // namespace pliant::test
