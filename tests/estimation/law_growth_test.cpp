// Branches of friction that grow beside the curve: as many as made the data, and no more.

#include "pliant/estimation/law_growth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/virtual_study.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::knit_of_two_branches;
using test::lab_of;
using test::made_up_material;
using test::relative_error;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

VirtualTensileCycles read_with_noise(double force_noise) {
  VirtualTensileCycles test = strip_cycles({0.05, 0.1, 0.2, 0.35});
  test.instrument.force_noise = force_noise;
  return test;
}

StudyResult fitted(const Material& truth, const VirtualTensileCycles& test,
                   const std::string& model) {
  VirtualStudy study(lab_of(truth, test));
  study.set_model(model);
  return study.fit();
}

std::size_t branches(const StudyResult& result) {
  return 1 + result.material.components.at("stretch.warp").addends.size();
}

TEST(LawGrowth, FindsTheBranchesThatMadeTheData) {
  const Material truth = knit_of_two_branches(ScalarCurve::affine(50, 30));
  for (const char* friction : {"dahl-2", "dahl-n"}) {
    const StudyResult result =
        fitted(truth, read_with_noise(0), std::string("stiffness: affine, friction: ") + friction);
    ASSERT_EQ(branches(result), 2u) << friction;
    for (const ParameterEstimate& p : result.parameters) {
      EXPECT_LT(relative_error(result, truth, p.name), 1e-4) << friction << ' ' << p.name;
    }
  }
}

TEST(LawGrowth, ChoosesBetweenPointsAndBranches) {
  const Material truth = knit_of_two_branches(ScalarCurve::hermite({0, 0.2, 0.4}, {90, 40, 60}));
  const StudyResult two = fitted(truth, read_with_noise(3e-3), "friction: dahl-n");
  EXPECT_EQ(branches(two), 2u);
  const StudyResult one = fitted(truth, read_with_noise(3e-3), "friction: dahl");
  EXPECT_LT(two.experiments.front().rms_percent, 0.7 * one.experiments.front().rms_percent);
  EXPECT_LT(estimate_named(two, "stretch.warp.friction.tau").value,
            estimate_named(two, "stretch.warp.dahl.tau").value);
  std::vector<std::string> tried;
  for (const FitStage& stage : two.stages) tried.push_back(stage.name);
  EXPECT_THAT(tried, Contains("1 control point, 2 branches"));
  EXPECT_NE(two.stages.back().ended, "");
}

TEST(LawGrowth, TakesFewerBranchesThanAskedForWhereOneIsEnough) {
  const Material truth = made_up_material(
      "stretch.warp", {ScalarCurve::affine(50, 30), FrictionLaw::dahl, {1.2, 2, 0.01}});
  const StudyResult asked =
      fitted(truth, read_with_noise(5e-3), "stiffness: affine, friction: dahl-3");
  EXPECT_EQ(branches(asked), 1u);
  EXPECT_THAT(asked.undetermined,
              Contains(HasSubstr("2 of 3 branches of friction of stretch.warp")));
  const StudyResult left =
      fitted(truth, read_with_noise(5e-3), "stiffness: affine, friction: dahl-n");
  EXPECT_EQ(branches(left), 1u);
  EXPECT_THAT(left.undetermined, Not(Contains(HasSubstr("branches of friction"))));
}

TEST(LawGrowth, IsRefusedByThePublishedEstimator) {
  VirtualStudy study(lab_of(knit_of_two_branches(ScalarCurve::affine(50, 30)), read_with_noise(0)));
  study.set_model("stiffness: affine, friction: dahl-2");
  study.add("fit: {estimator: anchor}");
  const std::string error = test::input_error_of([&] { study.fit(); }).what();
  EXPECT_THAT(error, HasSubstr("model.friction"));
  EXPECT_THAT(error, HasSubstr("one branch"));
}

}  // namespace
}  // namespace pliant
