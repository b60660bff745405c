// What a fit finds in bending lengths: one number, made by a finer elastica than the fit's.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"

#include "estimation/virtual_study.h"
#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::lab_of;
using test::published_bending_material;
using test::pushed_strips;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kStiffness = 6e-6;  // N m

Material elastic_fabric(const ScalarCurve& stiffness) {
  Material material = test::made_up_material("bend.warp", {stiffness, FrictionLaw::none, {}});
  material.density = 0.2;
  return material;
}

TEST(BendingLengthFit, GivesTheStiffnessOfAnElasticStripBack) {
  const Material fabric = elastic_fabric(ScalarCurve::constant(kStiffness));
  const StudyResult result = VirtualStudy(lab_of(fabric, pushed_strips())).fit();
  ASSERT_EQ(result.parameters.size(), 1u);
  EXPECT_EQ(result.parameters[0].name, "bend.warp.k");
  // The finer elastica differs by 1e-9.
  EXPECT_NEAR(result.parameters[0].value, kStiffness, 1e-7 * kStiffness);
  EXPECT_TRUE(result.parameters[0].identified);
}

// Peirce's closed formula, c = l (cos(angle / 2) / (8 tan angle))^(1/3), is 2 % off in c.
TEST(BendingLengthFit, AgreesWithPeircesFormulaWithinItsAccuracy) {
  const Material fabric = elastic_fabric(ScalarCurve::constant(kStiffness));
  const StudyResult result = VirtualStudy(lab_of(fabric, pushed_strips())).fit();
  const double overhang = result.experiments[0].measured(0);
  const double length =
      overhang * std::cbrt(std::cos(kOverhangAngle / 2) / (8 * std::tan(kOverhangAngle)));
  const double rigidity = 0.2 * kStandardGravity * std::pow(length, 3);
  EXPECT_NEAR(3 * result.parameters[0].value / rigidity, 1, 0.06);
}

TEST(BendingLengthFit, SaysThatItDeterminesOneNumber) {
  const Material fabric = elastic_fabric(ScalarCurve::affine(kStiffness, 2e-8));
  VirtualStudy study(lab_of(fabric, pushed_strips()));
  EXPECT_THAT(study.fit().undetermined,
              Contains(HasSubstr("stiffness of bend.warp at other curvatures")));
  study.set_model("stiffness: affine");
  const StudyResult affine = study.fit();
  EXPECT_FALSE(estimate_named(affine, "bend.warp.k1").identified);
  EXPECT_FALSE(estimate_named(affine, "bend.warp.k2").identified);
  EXPECT_LT(affine.experiments[0].rms, 1e-7 * affine.experiments[0].measured(0));
}

TEST(BendingLengthFit, LeavesFrictionUndetermined) {
  const StudyResult result =
      VirtualStudy(lab_of(published_bending_material("felt"), pushed_strips())).fit();
  EXPECT_THAT(result.undetermined, Contains(HasSubstr("friction of bend.warp")));
  // Read as an elastic strip, one with friction is stiffer than its elasticity.
  EXPECT_GT(result.parameters[0].value,
            test::truth_of(published_bending_material("felt"), "bend.warp.k1"));
}

// A spread of 1 % of readings is one of 3 % in the stiffness, less the root of their number.
TEST(BendingLengthFit, CarriesTheSpreadOfTheReadingsIntoTheStandardError) {
  auto noisy = pushed_strips();
  noisy.repeats = 50;
  const Material fabric = elastic_fabric(ScalarCurve::constant(kStiffness));
  const double overhang = std::cbrt(8.0042 * 3 * kStiffness / (0.2 * kStandardGravity));
  noisy.instrument.length_noise = 0.01 * overhang;
  const StudyResult result = VirtualStudy(lab_of(fabric, noisy), 7).fit();
  const ParameterEstimate& k = result.parameters[0];
  EXPECT_NEAR(*k.std_error / k.value, 0.03 / std::sqrt(100), 0.001);  // 7 % by chance of 100
  EXPECT_NEAR(k.value, kStiffness, 4 * *k.std_error);
}

TEST(BendingLengthFit, OfOneReadingSaysThatItAssumedTheNoise) {
  VirtualStudy study(lab_of(elastic_fabric(ScalarCurve::constant(kStiffness)), pushed_strips()));
  study.edit_rows("lengths.csv", [](VirtualStudy::Rows& rows) { rows.resize(1); });
  const StudyResult result = study.fit();
  EXPECT_NEAR(result.parameters[0].value, kStiffness, 1e-7 * kStiffness);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("cannot tell its noise")));
  // An overhang goes with the cube root of the stiffness: 1 % of it is 3 % of that.
  EXPECT_NEAR(*result.parameters[0].std_error / kStiffness, 0.03, 0.001);
}

}  // namespace
}  // namespace pliant
