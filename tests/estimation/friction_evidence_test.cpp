// What a fit says about friction when the data tells little of it.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;

/// Keeps the rows of the first loading alone.
void keep_loading(VirtualStudy& study) {
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) {
    size_t top = 1;
    while (top < rows.size() && rows[top][1] > rows[top - 1][1]) ++top;
    rows.resize(top);
  });
}

TEST(LoadingOnly, DeterminesNoFriction) {
  VirtualStudy study(lab_of(published_fabric("polyester"), strip_cycles({0.2})));
  keep_loading(study);
  const StudyResult result = study.fit();
  EXPECT_THAT(result.undetermined, Contains(HasSubstr("friction of stretch.warp")));
  EXPECT_FALSE(result.material.components.at("stretch.warp").friction.has_value());
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_THAT(p.name, ::testing::Not(HasSubstr("friction")));
  }
  EXPECT_FALSE(result.experiments.front().measured_loop.has_value());
}

// The elastic curve takes friction's share of the loading branch: that is what the words "not
// determined" are for.
TEST(LoadingOnly, StillFitsTheLoadingBranch) {
  VirtualStudy study(lab_of(published_fabric("polyester"), strip_cycles({0.2})));
  keep_loading(study);
  // Five points of stiffness cannot follow the saturation of friction exactly; a percent is near
  // enough to be useful.
  EXPECT_LT(study.fit().experiments.front().rms_percent, 1);
}

TEST(LoadingOnly, FrictionThatIsAskedForIsFittedAndFlagged) {
  VirtualStudy study(lab_of(published_fabric("polyester"), strip_cycles({0.2})));
  keep_loading(study);
  study.set_model("stiffness: affine, friction: dahl");
  const StudyResult result = study.fit();
  EXPECT_TRUE(result.material.components.at("stretch.warp").friction.has_value());
  EXPECT_THAT(result.undetermined, Contains(HasSubstr("the data only loads")));
}

TEST(FrictionChoice, NoneLeavesFrictionOut) {
  VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  study.set_model("friction: none");
  const StudyResult result = study.fit();
  EXPECT_EQ(result.parameters.size(), 2u);
  EXPECT_FALSE(result.material.components.at("stretch.warp").friction.has_value());
}

TEST(FrictionOfAnElasticMaterial, IsNotFoundToBeThere) {
  Material elastic = published_fabric("cotton");
  elastic.components.at("stretch.warp").friction.reset();
  auto experiment = hung_weights();
  experiment.instrument.length_noise = 0.2e-3;
  const StudyResult result = VirtualStudy(lab_of(elastic, experiment)).fit();
  const ParameterEstimate a = estimate_named(result, "stretch.warp.friction.a");
  EXPECT_TRUE(a.at_bound || !a.identified || a.value < 0.05) << a.value;
  EXPECT_FALSE(estimate_named(result, "stretch.warp.friction.tau").identified);
}

VirtualLab one_small_loop() {
  auto experiment = hung_weights();
  experiment.peaks = {2};
  experiment.repeats = 1;
  experiment.instrument.length_noise = 0.2e-3;
  return lab_of(published_fabric("polyester"), experiment);
}

TEST(AsManyRowsAsParameters, FitExactlyAndSayThatTheNoiseWasAssumed) {
  const StudyResult result = VirtualStudy(one_small_loop()).fit();
  EXPECT_EQ(result.experiments.front().points, 5);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("cannot tell its noise")));
  EXPECT_THAT(result.experiments.front().noise_source, HasSubstr("assumed: 1 %"));
}

TEST(AsManyRowsAsParameters, AreJudgedByAStatedNoise) {
  VirtualStudy study(one_small_loop());
  study.add_to_experiment("noise: {length: 0.2 mm}");
  const StudyResult result = study.fit();
  EXPECT_NE(estimate_named(result, "stretch.warp.friction.tau").determination,
            Determination::within_10_percent);
  EXPECT_TRUE(estimate_named(result, "stretch.warp.k1").std_error.has_value());
}

}  // namespace
}  // namespace pliant
