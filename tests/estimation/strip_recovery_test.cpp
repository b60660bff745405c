// What a fit finds in the profiles of strips without noise, made from known parameters by a finer
// elastica than the fit's.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "estimation/virtual_study.h"
#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::lab_of;
using test::overhanging_strips;
using test::published_bending_material;
using test::relative_error;
using test::rolled_strips;
using test::VirtualStudy;

constexpr double kRecovered = 5e-3;  // the project's number

TEST(SlowRolledStrip, OfThePublishedCylindersGivesFrictionBack) {
  const Material felt = published_bending_material("felt");
  const StudyResult result =
      VirtualStudy(lab_of(felt, rolled_strips(test::published_radii()))).fit();
  for (const std::string& name : test::names_of(felt, "bend.warp")) {
    EXPECT_LT(relative_error(result, felt, name), kRecovered) << name;
  }
  EXPECT_TRUE(result.converged);
}

class SlowRolledFabric : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowRolledFabric, TogetherWithCantileversGivesAllFiveParametersBack) {
  const Material fabric = published_bending_material(GetParam());
  const StudyResult result =
      VirtualStudy(lab_of(fabric, {rolled_strips(test::published_radii()),
                                   overhanging_strips({0.04, 0.06, 0.08, 0.1})}))
          .fit();
  for (const std::string& name : test::names_of(fabric, "bend.warp")) {
    EXPECT_LT(relative_error(result, fabric, name), kRecovered) << name;
  }
  EXPECT_TRUE(result.undetermined.empty());
}

INSTANTIATE_TEST_SUITE_P(Of, SlowRolledFabric, ::testing::Values("felt", "doublecloth"),
                         [](const auto& name) { return std::string(name.param); });

// Without friction a cantilever gives its stiffness alone.
TEST(Cantilever, GivesAffineStiffnessBack) {
  Material fabric =
      test::made_up_material("bend.warp", {ScalarCurve::affine(1e-5, 2e-8), FrictionLaw::none, {}});
  fabric.density = 0.2;
  VirtualStudy study(lab_of(fabric, overhanging_strips({0.04, 0.07, 0.1})));
  study.set_model("stiffness: affine");
  const StudyResult result = study.fit();
  for (const std::string& name : test::names_of(fabric, "bend.warp")) {
    EXPECT_LT(relative_error(result, fabric, name), kRecovered) << name;
  }
}

Material elastic_fabric() {
  Material fabric =
      test::made_up_material("bend.warp", {ScalarCurve::constant(1e-5), FrictionLaw::none, {}});
  fabric.density = 0.2;
  return fabric;
}

// Of a strip whose stiffness is known the profile tells the weight.
TEST(Cantilever, WeighsItsCloth) {
  VirtualStudy study(lab_of(elastic_fabric(), overhanging_strips({0.05, 0.08})));
  study.set_model("stiffness: constant");
  study.add_to_experiment("density: unknown");
  study.add("fit: {fix: {bend.warp.k: 1.1e-5}}");
  const StudyResult result = study.fit();
  ASSERT_EQ(result.nuisance.size(), 1u);
  EXPECT_EQ(result.nuisance[0].name, "overhangs.density");
  EXPECT_NEAR(result.nuisance[0].value, 0.22, 1e-5);
}

// A profile sees stiffness over weight alone.
TEST(Cantilever, SaysThatStiffnessAndWeightAreNotToldApart) {
  VirtualStudy study(lab_of(elastic_fabric(), overhanging_strips({0.05, 0.08})));
  study.set_model("stiffness: constant");
  study.add_to_experiment("density: unknown");
  const StudyResult result = study.fit();
  EXPECT_FALSE(result.nuisance[0].identified);
  ASSERT_FALSE(result.parameters.empty());
  EXPECT_FALSE(result.parameters[0].identified);
}

}  // namespace
}  // namespace pliant
