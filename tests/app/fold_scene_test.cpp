// The fold of examples/fold.yaml at reduced size: what a strip keeps that is elastic, one with Dahl
// friction and one that yields ([T] Fig. 2.2).

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

// Frames after the first fold, after the push from the other side and after the second fold.
constexpr size_t kFirst = 20, kPushed = 40, kSecond = 60;

std::string file_of(const std::string& name) {
  return SceneFolder::example("fold/" + name + ".json").string();
}

/// The scene at reduced size.
std::string small_fold(const std::string& duration = "6 s") {
  return edited_text(content_of(SceneFolder::example("fold.yaml")),
                     {{"nodes: 41x17", "nodes: 21x9"},
                      {"fold/sheet.json", file_of("sheet")},
                      {"duration: 6 s", "duration: " + duration}});
}

/// Simulates the scene that stands in a folder with one of the files of examples/fold: in the end
/// the strip does not pass through itself.
void simulate(const SceneFolder& folder, const std::string& bending,
              const std::vector<std::string>& more = {}, const std::string& out = "out") {
  std::vector<std::string> arguments{
      "simulate", folder.file("scene.yaml"), "-o",          folder.results(out).string(),
      "--fill",   file_of(bending),          "--no-report", "--threads",
      "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string result = content_of(folder.results(out) / "simulation.json");
  EXPECT_EQ(nlohmann::json::parse(result)["crossing_pairs"], 0);
}

class FoldedStrip {
 public:
  /// @param time  its duration, and more of the scene's time
  explicit FoldedStrip(const std::string& bending, const std::string& time = "6 s") {
    folder_.write("scene.yaml", small_fold(time));
    simulate(folder_, bending);
    const ProgramRun run = run_program({"compare", folder_.results().string(), "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const nlohmann::json compared = nlohmann::json::parse(run.out);
    for (const auto& frame : compared["frames"]) left_.push_back(frame["curvature"]);
  }

  /// Curvature that a frame has left, root mean square over the strip (1/m).
  double left(size_t frame) const { return left_.at(frame); }

 private:
  SceneFolder folder_;
  std::vector<double> left_;
};

// The strip moves a little when it is let go, and air and inertia are no part of the laws: what an
// elastic strip has left is what there is to see of that.
TEST(SlowFoldScene, TellsFrictionFromPlasticityAndFromBoth) {
  const FoldedStrip elastic("elastic"), rubbing("dahl"), yielding("plastic");
  double seen = 0;
  for (const size_t frame : {kFirst, kPushed, kSecond}) seen = std::max(seen, elastic.left(frame));

  // Both keep the first fold.
  EXPECT_GT(rubbing.left(kFirst), 5 * seen);
  EXPECT_GT(yielding.left(kFirst), 5 * seen);
  // A small push undoes the one and not the other.
  EXPECT_LT(rubbing.left(kPushed), 0.6 * rubbing.left(kFirst));
  EXPECT_NEAR(yielding.left(kPushed), yielding.left(kFirst), 0.15 * yielding.left(kFirst));
  // A larger fold is kept no better by friction, which was saturated, and far better by yield.
  EXPECT_LT(rubbing.left(kSecond), 2 * rubbing.left(kFirst));
  EXPECT_GT(yielding.left(kSecond), 3.5 * yielding.left(kFirst));

  // What [T] 2.1.4 has plasticity for: creases of extreme folds, beside friction.
  const FoldedStrip both("dahl-plastic");
  for (const size_t frame : {kFirst, kPushed}) {
    EXPECT_NEAR(both.left(frame), rubbing.left(frame), 0.05 * rubbing.left(frame)) << frame;
  }
  EXPECT_GT(both.left(kSecond), 2.5 * rubbing.left(kSecond));
}

// Steps that end before strains have come to rest let go what friction holds.
TEST(SlowFoldScene, IsKeptByFrictionAsInStepsThatConverge) {
  const FoldedStrip iterated("dahl", "4 s"), converged("dahl", "4 s, solve: converged");
  for (const size_t frame : {kFirst, kPushed}) {
    EXPECT_NEAR(iterated.left(frame), converged.left(frame), 0.05 * converged.left(frame)) << frame;
  }
}

TEST(SlowFoldScene, OfAStripThatYieldsIsGoneOnWithToTheSameBits) {
  const SceneFolder folder;
  folder.write("scene.yaml", small_fold("1.6 s"));
  simulate(folder, "plastic", {}, "whole");
  folder.write("scene.yaml", small_fold("1 s"));
  simulate(folder, "plastic");
  folder.write("scene.yaml", small_fold("1.6 s"));
  simulate(folder, "plastic", {"--resume"});
  expect_same_files(folder.computed_files("whole"), folder.computed_files());
}

// Yield is no friction. An exact test after each step takes longer than the steps, so that the long
// runs have none.
TEST(SlowFoldScene, OfAStripThatYieldsIsKeptWithoutFriction) {
  const SceneFolder folder;
  folder.write("scene.yaml", small_fold("1.2 s"));
  simulate(folder, "plastic", {"--verify"});
  simulate(folder, "plastic", {"--no-friction"}, "without");
  expect_same_files(folder.computed_files(), folder.computed_files("without"));
}

}  // namespace
}  // namespace pliant::test
