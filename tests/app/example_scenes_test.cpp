// The scenes of examples/ at reduced size: they run, and show what they say.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "app/reduced_example.h"

namespace pliant::test {
namespace {

void expect_every_frame(const ReducedExample& example, const std::string& name) {
  EXPECT_EQ(example.result["finished"], true);
  EXPECT_EQ(example.result["name"], name);
  ASSERT_GE(example.result["frames"].size(), 2u);
  for (size_t i = 0; i < example.result["frames"].size(); ++i) {
    EXPECT_EQ(example.frame(i).cols(), example.result["vertices"]);
    EXPECT_TRUE(example.frame(i).allFinite());
  }
}

class SlowExampleScene : public ::testing::TestWithParam<std::string> {};

TEST_P(SlowExampleScene, RunsToItsEndAndWritesEveryFrame) {
  expect_every_frame(ReducedExample(GetParam()), GetParam());
}

/// But those of which more is told below.
std::vector<std::string> names_of_reduced_examples() {
  std::vector<std::string> names;
  for (const auto& [name, edits] : kReductions) {
    const bool told = name == "cylinder-strip" || name == "hanging-weights";
    if (!told && name != "drape-sphere") names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Examples, SlowExampleScene,
                         ::testing::ValuesIn(names_of_reduced_examples()), [](const auto& name) {
                           std::string text = name.param;
                           std::replace(text.begin(), text.end(), '-', '_');
                           return text;
                         });

// fab-stretch needs a material that is fitted to measurements: see tests/real; strips that unroll
// are compared with elasticas: see tests/experiments_3d; the fold is told of in
// fold_scene_test.cpp.
TEST(ExampleScenes, AreAllTested) {
  std::set<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(PLIANT_SOURCE_DIR "/examples")) {
    if (entry.path().extension() == ".yaml") scenes.insert(entry.path().stem().string());
  }
  EXPECT_EQ(std::erase_if(scenes, [](const auto& name) { return name.starts_with("unroll-"); }),
            9u);
  EXPECT_EQ(scenes.erase("fab-stretch"), 1u);
  EXPECT_EQ(scenes.erase("fold"), 1u);
  for (const auto& [name, edits] : kReductions) EXPECT_EQ(scenes.erase(name), 1u) << name;
  for (const auto& [name, edits] : kFrictionReductions) EXPECT_EQ(scenes.erase(name), 1u) << name;
  EXPECT_TRUE(scenes.empty()) << *scenes.begin();
}

TEST(SlowExampleScenes, CylinderStripKeepsTheCurvatureOfItsFriction) {
  const ReducedExample example("cylinder-strip");
  expect_every_frame(example, "cylinder-strip");
  const Eigen::Matrix3Xd at = example.last_frame();
  constexpr int kNodes = 41;  // along the strip; the first two are held
  for (int i = 4; i < kNodes - 4; i += 4) {
    const Eigen::Vector3d before = at.col(i) - at.col(i - 1), after = at.col(i + 1) - at.col(i);
    const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
    const double curvature = 2 * angle / (before.norm() + after.norm());
    // The strip has not quite come to rest, and waves a little from hinge to hinge.
    EXPECT_NEAR(curvature, 20, 0.02 * 20) << i;
  }
}

TEST(SlowExampleScenes, DrapeSpherePassesThroughNothingInAnyStep) {
  const ReducedExample example("drape-sphere", {}, {"--verify", "--no-report"});
  expect_every_frame(example, "drape-sphere");
  EXPECT_EQ(example.result["crossing_pairs"], 0);
}

TEST(SlowExampleScenes, HangingWeightsLeaveTheSheetLongerOnTheWayBack) {
  const ReducedExample example("hanging-weights");
  expect_every_frame(example, "hanging-weights");
  const auto length = [&](size_t frame) {
    const Eigen::Matrix3Xd at = example.frame(frame);
    return at.row(2).maxCoeff() - at.row(2).minCoeff();
  };
  // 1 N at 1 s and again at 3 s; 2 N at 14 s and again at 22 s.
  EXPECT_GT(length(3), length(1) + 1e-3);
  EXPECT_GT(length(22), length(14) + 1e-3);
  EXPECT_GT(length(24), 0.1 + 1e-3);
}

TEST(SlowExampleScenes, CurtainSettlesSoonerAndElsewhereWithFriction) {
  // 3 s are enough for a picture, not to come to rest.
  const TextEdit longer{"duration: 3 s", "duration: 8 s, solve: converged"};
  const ReducedExample rough("curtain", {longer}), elastic("curtain-elastic", {longer});
  // The means of the last 3 s.
  constexpr size_t kFrames = 80, kFirst = 50;
  const auto motion = [](const ReducedExample& example) {
    const std::vector<double> kinetic = example.energies("kinetic_J");
    return std::accumulate(kinetic.begin() + kFirst, kinetic.end(), 0.0);
  };
  const auto shape = [](const ReducedExample& example) {
    Eigen::Matrix3Xd sum = example.frame(kFirst);
    for (size_t i = kFirst + 1; i <= kFrames; ++i) sum += example.frame(i);
    return Eigen::Matrix3Xd(sum / (kFrames - kFirst + 1));
  };
  ASSERT_EQ(rough.energies("time_s").size(), kFrames + 1);
  EXPECT_LT(motion(rough), motion(elastic) / 2);
  const Eigen::Matrix3Xd apart = shape(rough) - shape(elastic);
  EXPECT_GT(apart.colwise().norm().maxCoeff(), 0.01);  // m, of a curtain of 1 m
}

}  // namespace
}  // namespace pliant::test
