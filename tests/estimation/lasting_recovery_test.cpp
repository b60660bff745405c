// Softening, permanent set and what relaxes with time, found from what virtual testers measure.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/material/addend/addend_registry.h"

#include "estimation/virtual_study.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::lab_of;
using test::made_up_material;
using test::measurements_of;
using test::relative_error;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::HasSubstr;

Material with_addend(const char* kind, const Eigen::VectorXd& values,
                     const std::string& component = "stretch.warp") {
  ComponentLaw law{ScalarCurve::affine(50, 30), FrictionLaw::dahl, {1.2, 2, 0.01}};
  law.addends = {{*find_addend_kind(kind), values}};
  return made_up_material(component, law);
}

VirtualTensileCycles pulled_within(double seconds, const std::string& name) {
  VirtualTensileCycles test = strip_cycles({0.05, 0.1, 0.2});
  test.name = name;
  test.duration = seconds;
  return test;
}

std::string model_with(const std::string& kind, const std::string& component = "stretch.warp") {
  return "components: {" + component + ": {stiffness: affine, addends: [" + kind + "]}}";
}

void expect_all_found(const StudyResult& result, const Material& truth) {
  EXPECT_TRUE(result.converged);
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_LT(relative_error(result, truth, p.name), 1e-4) << p.name;
  }
}

TEST(LastingRecovery, OfLoopsThatGrowFindsWhatTheyTookAway) {
  for (const auto& [kind, values] :
       {std::pair<const char*, Eigen::VectorXd>{"softening", Eigen::Vector2d(60, 0.15)},
        {"set", Eigen::VectorXd::Constant(1, 20)}}) {
    const Material truth = with_addend(kind, values);
    VirtualStudy study(lab_of(truth, strip_cycles({0.05, 0.1, 0.2, 0.35})));
    study.set_model(model_with(kind));
    expect_all_found(study.fit(), truth);
  }
}

// A long strip, and then a short piece of it, which has been softened and is longer by then.
TEST(LastingRecovery, FollowsAStripFromOneTestToTheNext) {
  const Material truth = with_addend("softening", Eigen::Vector2d(60, 0.15));
  VirtualTensileCycles before = strip_cycles({0.05, 0.3}), again = strip_cycles({0.1, 0.2});
  before.name = "long";
  again.name = "short";
  again.length = 0.02;
  const auto fresh = measurements_of(lab_of(truth, {before, again}));
  again.before = std::make_shared<VirtualTensileCycles>(before);
  const VirtualLab lab = lab_of(truth, {before, again});
  EXPECT_EQ(measurements_of(lab)[0], fresh[0]);
  EXPECT_NE(measurements_of(lab)[1], fresh[1]);
  VirtualStudy study(lab);
  study.set_model(model_with("softening"));
  expect_all_found(study.fit(), truth);
}

// The strip of the fast test is slack at the end of its cycles, and relaxes meanwhile.
TEST(LastingRecovery, OfTwoSpeedsFindsWhatRelaxes) {
  const Material truth = with_addend("maxwell", Eigen::Vector2d(60, 8));
  VirtualStudy study(lab_of(truth, {pulled_within(20, "fast"), pulled_within(400, "slow")}));
  study.set_model(model_with("maxwell"));
  expect_all_found(study.fit(), truth);
}

TEST(LastingRecovery, OfTwoSpeedsFindsFrictionThatGrowsWithTheRate) {
  const Material truth = with_addend("rate-friction", Eigen::Vector4d(0.8, 1, 0.03, 0.06));
  VirtualStudy study(lab_of(truth, {pulled_within(20, "fast"), pulled_within(4000, "slow")}));
  study.set_model(model_with("rate-friction"));
  expect_all_found(study.fit(), truth);
}

TEST(LastingRecovery, OfAngledSpeedsFindsWhatRelaxesInShear) {
  const Material truth = with_addend("maxwell", Eigen::Vector2d(60, 8), "shear");
  VirtualShearCycles test;
  test.name = "cycles";
  test.peaks = {0.1, 0.3};
  test.duration = 30;
  VirtualStudy study(lab_of(truth, test));
  study.set_model(model_with("maxwell", "shear"));
  expect_all_found(study.fit(), truth);
}

TEST(LastingRecovery, SaysWhereNothingReturns) {
  VirtualStudy study(
      lab_of(with_addend("softening", Eigen::Vector2d(60, 0.15)), strip_cycles({0.2})));
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) { rows.resize(rows.size() / 2); });
  study.set_model(model_with("softening"));
  const StudyResult result = study.fit();
  EXPECT_THAT(result.undetermined,
              ::testing::Contains(HasSubstr("softening of stretch.warp: the data only loads")));
}

TEST(LastingRecovery, AsksForTimesOfWhatRelaxes) {
  VirtualStudy study(lab_of(with_addend("maxwell", Eigen::Vector2d(60, 8)), strip_cycles({0.1})));
  study.set_model(model_with("maxwell"));
  const std::string problem = test::input_error_of([&] { study.fit(); }).what();
  EXPECT_THAT(problem, HasSubstr("model.components.stretch.warp.addends"));
  EXPECT_THAT(problem, HasSubstr("does not tell when its rows were measured"));
}

TEST(LastingRecovery, RefusesTimesThatGoBack) {
  VirtualStudy study(
      lab_of(with_addend("maxwell", Eigen::Vector2d(60, 8)), pulled_within(20, "cycles")));
  study.set_model(model_with("maxwell"));
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) { rows[40].back() = 0; });
  EXPECT_THAT(test::input_error_of([&] { study.fit(); }).what(), HasSubstr("goes back in time"));
}

}  // namespace
}  // namespace pliant
