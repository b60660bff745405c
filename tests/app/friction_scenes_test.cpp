// The examples that show what internal friction does ([T] 5.5), at reduced size, with it and
// without: the measured quantity tells the two apart, and nothing passes through anything.

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
  for (const int frame : {14, 21}) {
    EXPECT_GT(difference(pair.rough, frame, 7)["distance"], 2e-4) << frame;
    EXPECT_LT(difference(pair.elastic, frame, 7)["distance"], 1e-5) << frame;
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

// [T] Fig. 5.15: pushed from the top at 1.1 s and from the bottom at 1.7 s, and so again at an
// angle.
TEST(SlowFrictionScenes, AStretchedPlaceWrinklesFromWhicheverSideItIsPushed) {
  const Pair pair("preferred-wrinkle");
  for (const auto& [frame, with] : {std::pair(17, 11), std::pair(29, 23)}) {
    const double rough = difference(pair.rough, frame, with)["curvature"];
    EXPECT_GT(difference(pair.elastic, frame, with)["curvature"], 5 * rough) << frame;
  }
}

}  // namespace
}  // namespace pliant::test
