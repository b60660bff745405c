#include "pliant/estimation/unknown.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

VirtualLab noisy_weights(const std::string& fabric) {
  auto experiment = hung_weights();
  experiment.instrument.length_noise = 0.2e-3;
  return lab_of(published_fabric(fabric), experiment);
}

TEST(Bounds, HoldAParameterAndAreReported) {
  VirtualStudy study(noisy_weights("cotton"));
  study.add("fit: {bounds: {stretch.warp.friction.a: [2.5, 3]}}");  // the truth is 2.22
  const StudyResult result = study.fit();
  const ParameterEstimate a = estimate_named(result, "stretch.warp.friction.a");
  EXPECT_EQ(a.value, 2.5);
  EXPECT_TRUE(a.at_bound);
  EXPECT_FALSE(a.identified);
  EXPECT_FALSE(a.std_error.has_value());
  EXPECT_THAT(result.undetermined,
              Contains("stretch.warp.friction.a (the data pushes it to its bound)"));
  EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("at its bound")))) << "it is said once";
  EXPECT_TRUE(estimate_named(result, "stretch.warp.k1").identified);
}

TEST(Bounds, ApplyByPattern) {
  VirtualStudy study(noisy_weights("cotton"));
  study.add("fit: {bounds: {'*.tau': [0.02, 0.1]}}");  // the truth is 0.006
  EXPECT_EQ(estimate_named(study.fit(), "stretch.warp.friction.tau").value, 0.02);
}

TEST(FixedParameters, KeepTheirValueAndHaveNoError) {
  VirtualStudy study(noisy_weights("cotton"));
  study.add("fit: {fix: {stretch.warp.friction.b: 0}}");
  const StudyResult result = study.fit();
  const ParameterEstimate b = estimate_named(result, "stretch.warp.friction.b");
  EXPECT_EQ(b.value, 0);
  EXPECT_TRUE(b.fixed);
  EXPECT_FALSE(b.std_error.has_value());
  // What was stated is not something that the data fails to determine.
  EXPECT_THAT(result.undetermined, ::testing::Not(Contains(HasSubstr("friction.b"))));
}

TEST(FixedParameters, ANameGoesBeforeAPattern) {
  VirtualStudy study(noisy_weights("cotton"));
  study.add("fit: {fix: {'*.friction.*': 1, stretch.warp.friction.tau: 0.01}}");
  const StudyResult result = study.fit();
  EXPECT_EQ(estimate_named(result, "stretch.warp.friction.tau").value, 0.01);
  EXPECT_EQ(estimate_named(result, "stretch.warp.friction.a").value, 1);
}

TEST(FixedParameters, NoiseFreeTruthLeavesTheOthersTrue) {
  VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  study.add("fit: {fix: {'*.tau': 0.006}}");
  // 1e-6: as without it.
  EXPECT_NEAR(estimate_named(study.fit(), "stretch.warp.k1").value, 135.6, 135.6e-6);
}

TEST(Priors, CountAsOneMoreMeasurement) {
  const VirtualLab lab = noisy_weights("polyester");
  const ParameterEstimate data =
      estimate_named(VirtualStudy(lab).fit(), "stretch.warp.friction.tau");
  // A prior as sharp as the data, two standard errors off: the answer lies half way, its error
  // falls by sqrt 2.
  const double mean = data.value + 2 * *data.std_error;
  VirtualStudy study(lab);
  study.add(fmt::format("fit: {{priors: {{stretch.warp.friction.tau: {{mean: {}, sd: {}}}}}}}",
                        mean, *data.std_error));
  study.add_to_experiment("noise: {length: 0.2 mm}");
  const ParameterEstimate both = estimate_named(study.fit(), "stretch.warp.friction.tau");
  // The problem is not quite linear, and the residuals' noise is not quite the stated one: within a
  // tenth.
  EXPECT_NEAR((both.value - data.value) / *data.std_error, 1, 0.1);
  EXPECT_NEAR(*both.std_error / *data.std_error, std::sqrt(0.5), 0.1);
}

TEST(Priors, CountTheSameWhereTheNoiseIsEstimated) {
  const VirtualLab lab = noisy_weights("polyester");
  const ParameterEstimate data =
      estimate_named(VirtualStudy(lab).fit(), "stretch.warp.friction.tau");
  const double mean = data.value + 2 * *data.std_error;
  VirtualStudy study(lab);
  study.add(
      fmt::format("fit: {{priors: {{'*.tau': {{mean: {}, sd: {}}}}}}}", mean, *data.std_error));
  const ParameterEstimate both = estimate_named(study.fit(), "stretch.warp.friction.tau");
  EXPECT_NEAR((both.value - data.value) / *data.std_error, 1, 0.1);
}

TEST(Unknowns, OfALawMayNotBecomeNegative) {
  const ComponentLaw law{ScalarCurve::affine(0, 0), FrictionLaw::dahl, {}};
  const std::vector<Unknown> unknowns = unknowns_of(law, {"stretch.warp"}, {40, 0.2});
  ASSERT_EQ(unknowns.size(), 5U);
  const std::array<const char*, 5> names{"k1", "k2", "friction.a", "friction.b", "friction.tau"};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(unknowns[i].name, std::string("stretch.warp.") + names[i]);
    EXPECT_GT(unknowns[i].scale, 0);
    EXPECT_TRUE(i == 4 || unknowns[i].lower == 0);
  }
  EXPECT_DOUBLE_EQ(unknowns[4].lower, 2e-4);  // a thousandth of the largest strain
  EXPECT_DOUBLE_EQ(unknowns[4].upper, 0.6);   // three times it
}

TEST(Unknowns, OfAGroupSetTheParametersOfAllItsComponents) {
  const ComponentLaw law{ScalarCurve::constant(5), FrictionLaw::none, {}};
  const std::vector<Unknown> unknowns =
      unknowns_of(law, {"stretch.weft", "stretch.warp"}, {1, 0.1});
  ASSERT_EQ(unknowns.size(), 1U);
  EXPECT_THAT(unknowns[0].parameters, ::testing::ElementsAre("stretch.weft.k", "stretch.warp.k"));
  EXPECT_EQ(unknowns[0].start, 5);
}

}  // namespace
}  // namespace pliant
