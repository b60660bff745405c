// Cantilevers and rolled strips: what their profiles say, measured and predicted.

#include "pliant/experiment/profile/strip_profiles.h"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/loop_metrics.h"
#include "pliant/study/study.h"

#include "support/study_folder.h"
#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::LabFolder;
using test::measurements_of;
using test::overhanging_strips;
using test::published_bending_material;
using test::rolled_strips;

/// The experiments of a lab on felt, read back from its files.
class Felt {
 public:
  explicit Felt(const std::vector<test::AnyTest>& experiments)
      : material_(published_bending_material("felt")),
        folder_(measurements_of(test::lab_of(material_, std::move(experiments)))),
        study_(folder_.study()) {
    for (const ExperimentSpec& spec : study_.experiments) {
      experiments_.push_back(read_experiment(spec, study_));
    }
  }
  const ComponentExperiment& operator[](size_t i) const { return *experiments_.at(i); }
  ComponentLaw law() const { return *law_of(material_, "bend.warp"); }
  Prediction prediction(size_t i) const { return *(*this)[i].predict(law(), {}, false); }

 private:
  Material material_;
  LabFolder folder_;
  Study study_;
  std::vector<std::unique_ptr<ComponentExperiment>> experiments_;
};

VirtualRolledStrip rolled_right(std::vector<double> radii) {
  for (double& radius : radii) radius = -radius;
  auto experiment = rolled_strips(std::move(radii));
  experiment.name = "rolls-right";
  return experiment;
}

TEST(StripProfiles, LieOnTheProfilesOfTheLawThatMadeThem) {
  const Felt felt({overhanging_strips({0.05, 0.1}), rolled_strips({0.004, -0.004, 0.01, 0.05})});
  // The lab's elements and steps are finer. Where points bend back and forth while the strip is let
  // go, the error falls with the length of the steps: 0.065 mm here, of 100 mm.
  EXPECT_LT(felt.prediction(0).value.cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(felt.prediction(1).value.cwiseAbs().maxCoeff(), 1e-4);
}

TEST(StripProfiles, OfACantileverLoadAndOfARolledStripUnload) {
  const Felt felt({overhanging_strips({0.1}), rolled_strips({0.004}), rolled_right({0.004})});
  EXPECT_FALSE(unloads(felt[0].path()));
  EXPECT_TRUE(unloads(felt[1].path()));
  EXPECT_TRUE(unloads(felt[2].path()));
}

TEST(StripProfiles, RolledToTheRightCurlToTheRight) {
  const Felt felt({rolled_strips({0.004}), rolled_right({0.004})});
  EXPECT_GT(felt.prediction(0).strain.maxCoeff(), 100);
  EXPECT_LT(felt.prediction(1).strain.minCoeff(), -100);
}

TEST(StripProfiles, AreMeasuredAgainstTheLengthOfTheStrip) {
  const Felt felt({overhanging_strips({0.05, 0.08}), rolled_strips({0.01})});
  EXPECT_DOUBLE_EQ(felt[0].reference(), 0.08);
  EXPECT_DOUBLE_EQ(felt[1].reference(), 0.1);
}

// The tighter half of the cylinders, which a search begins with.
TEST(StripProfiles, HaveAnEasyPart) {
  const Felt felt({rolled_strips({0.003, 0.004, 0.01, 0.05}), rolled_right({0.003, 0.01}),
                   overhanging_strips({0.05, 0.1})});
  const auto part = felt[0].easy_part();
  ASSERT_TRUE(part);
  const auto all = felt.prediction(0), some = *part->predict(felt.law(), {}, false);
  for (std::size_t row = 0; row < 100; ++row) {
    EXPECT_EQ(part->info().used[row], row < 50 && felt[0].info().used[row]) << row;
  }
  EXPECT_EQ(some.value.head(50), all.value.head(50));
  EXPECT_FALSE(felt[1].easy_part());
  EXPECT_FALSE(felt[2].easy_part());
}

TEST(StripProfiles, LeaveOutTheClamp) {
  const Felt felt({rolled_strips({0.004, 0.01})});
  const std::vector<char>& used = felt[0].info().used;
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 2);
  EXPECT_EQ(used[0], 0);
  EXPECT_EQ(used[25], 0);
}

TEST(StripShapes, HoldEveryMeasuredProfileAndOnePredictedForEachRadius) {
  auto rolled = rolled_strips({0.004, 0.01});
  rolled.repeats = 3;
  const Felt felt({rolled});
  const auto shapes = felt[0].shapes(felt.law(), {});
  ASSERT_TRUE(shapes);
  EXPECT_EQ(shapes->setting_name, "radius");
  EXPECT_EQ(shapes->measured.size(), 6u);
  EXPECT_EQ(shapes->predicted.size(), 2u);
  EXPECT_EQ(shapes->bent.size(), 2u);
  EXPECT_EQ(shapes->measured[3].first_row, 75);
  EXPECT_DOUBLE_EQ(shapes->measured[3].setting, 0.01);
}

// At rest every point carries the weight that hangs beyond it, on the way back from its cylinder.
TEST(StripShapes, PredictedPointsLieOnTheReturnFromTheCylinder) {
  const Felt felt({rolled_strips({0.004})});
  const auto shapes = felt[0].shapes(felt.law(), {});
  const BendingPath& bent = shapes->bent[0];
  const ProfileLine& line = shapes->predicted[0];
  const size_t turn = bent.curvature.size() / 2;
  EXPECT_DOUBLE_EQ(bent.curvature[turn], 250);
  for (const size_t i : {size_t{0}, line.x.size() / 3, line.x.size() - 1}) {
    // The return is sampled from the turn down to flat, evenly.
    const double place = static_cast<double>(turn) * (2 - line.curvature[i] / 250);
    const auto before = static_cast<size_t>(place);
    ASSERT_LT(before + 1, bent.moment.size());
    const double share = place - static_cast<double>(before);
    const double moment = (1 - share) * bent.moment[before] + share * bent.moment[before + 1];
    // Of the largest moment; what remains is the sampling of both lines.
    EXPECT_NEAR(line.moment[i], moment, 1e-3 * bent.moment[turn]) << line.arc_length[i];
  }
}

TEST(StripShapes, OfACantileverHaveNoPathOfRolling) {
  const Felt felt({overhanging_strips({0.1})});
  const auto shapes = felt[0].shapes(felt.law(), {});
  ASSERT_TRUE(shapes);
  EXPECT_EQ(shapes->setting_name, "overhang");
  EXPECT_TRUE(shapes->bent.empty());
  // At the clamp, of a strip that almost hangs: less than its whole weight at its whole length.
  EXPECT_LT(shapes->predicted[0].moment.front(), 0);
  EXPECT_GT(shapes->predicted[0].moment.front(), -0.208 * 9.80665 * 0.1 * 0.1 / 2);
}

TEST(VirtualProfiles, KeepTheClampFreeOfNoise) {
  auto rolled = rolled_strips({0.01});
  rolled.instrument.length_noise = 1e-3;
  const auto files = measurements_of(test::lab_of(published_bending_material("felt"), rolled));
  EXPECT_THAT(files.front().second, ::testing::HasSubstr("\n10,1,0,0,0\n"));
}

TEST(VirtualProfiles, AreTheSameBitsForTheSameSeed) {
  auto rolled = rolled_strips({0.005, 0.02});
  rolled.repeats = 2;
  rolled.instrument.length_noise = 1e-4;
  const VirtualLab lab = test::lab_of(published_bending_material("felt"), rolled);
  EXPECT_EQ(measurements_of(lab, 3), measurements_of(lab, 3));
  EXPECT_NE(measurements_of(lab, 3).front(), measurements_of(lab, 4).front());
}

TEST(VirtualProfiles, ScatterByTheirNoiseAcrossTheProfile) {
  auto rolled = rolled_strips({0.004, 0.01, 0.05});
  rolled.repeats = 3;
  rolled.points = 100;
  rolled.instrument.length_noise = 1e-4;
  const Felt felt({rolled});
  const double rms = std::sqrt(felt.prediction(0).value.squaredNorm() / felt[0].rows());
  EXPECT_NEAR(rms, 1e-4, 0.1e-4);  // of 900 points: 2.4 % is one standard error
}

}  // namespace
}  // namespace pliant
