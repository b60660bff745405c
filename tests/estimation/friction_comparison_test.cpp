#include "pliant/estimation/friction_comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::hung_weights;
using test::lab_of;
using test::made_up_material;
using test::published_fabric;
using test::VirtualStudy;

std::vector<ModelRank> ranks_for(const Material& material) {
  auto experiment = hung_weights();
  experiment.instrument.length_noise = 0.2e-3;
  return VirtualStudy(lab_of(material, experiment))
      .fit({.compare_friction = true, .profiles = {}})
      .models;
}

TEST(FrictionComparison, RanksTheLawThatMadeTheDataFirst) {
  const std::vector<ModelRank> ranks = ranks_for(published_fabric("spandex"));
  ASSERT_EQ(ranks.size(), 4u);
  EXPECT_EQ(ranks.front().name, "linear maximum, constant tau");
  EXPECT_EQ(ranks.front().delta_bic, 0);
  // Ten in BIC is very strong evidence (Kass and Raftery 1995).
  for (size_t i = 1; i < ranks.size(); ++i) EXPECT_GT(ranks[i].delta_bic, 10) << ranks[i].name;
  EXPECT_EQ(ranks.back().name, "no friction");
}

TEST(FrictionComparison, PrefersTheSimplerLawWhereItIsTrue) {
  // The maximum friction does not grow with strain.
  const std::vector<ModelRank> ranks = ranks_for(made_up_material(
      "stretch.warp", {ScalarCurve::affine(40, 60), FrictionLaw::dahl, {2, 0, 0.03}}));
  EXPECT_EQ(ranks.front().name, "constant maximum, constant tau");
  EXPECT_EQ(ranks.front().parameters, 4);
}

TEST(FrictionComparison, RanksByBicAndCountsFreeParameters) {
  const std::vector<ModelRank> ranks = ranks_for(published_fabric("cotton"));
  for (size_t i = 1; i < ranks.size(); ++i) EXPECT_LE(ranks[i - 1].bic, ranks[i].bic);
  for (const ModelRank& rank : ranks) {
    const int expected = rank.name == "no friction"                      ? 2
                         : rank.name == "constant maximum, constant tau" ? 4
                                                                         : 5;
    EXPECT_EQ(rank.parameters, expected) << rank.name;
    EXPECT_NEAR(rank.bic - rank.aic, (std::log(144) - 2) * rank.parameters, 1e-9)
        << rank.name << ": 144 rows with independent noise";
  }
}

TEST(FrictionComparison, IsLeftOutWithoutFriction) {
  VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  study.set_model("friction: none");
  EXPECT_TRUE(study.fit({.compare_friction = true, .profiles = {}}).models.empty());
}

}  // namespace
}  // namespace pliant
