#include "pliant/estimation/friction_comparison.h"

#include <algorithm>
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

// Each rival's curve grows anew: one that follows the loops needs more points than one that cannot.
TEST(FrictionComparison, GrowsTheCurveOfEachRival) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.1, 0.2, 0.3, 0.45}, {60, 45, 40, 60, 100});
  auto cycles = test::strip_cycles({0.05, 0.1, 0.2, 0.35});
  cycles.instrument.force_noise = 5e-3;
  const std::vector<ModelRank> ranks =
      VirtualStudy(
          lab_of(made_up_material("stretch.warp", {curve, FrictionLaw::dahl, {1.2, 2, 0.01}}),
                 cycles))
          .fit({.compare_friction = true, .profiles = {}})
          .models;
  // Beside its control points a rival has the numbers of friction and the offset of the force.
  const auto points = [&](const char* name, int friction) {
    const auto rank = std::ranges::find(ranks, name, &ModelRank::name);
    return rank == ranks.end() ? 0 : rank->parameters - friction - 1;
  };
  const int rubbing = points("linear maximum, constant tau", 3), elastic = points("no friction", 0);
  EXPECT_GT(elastic, 1);
  EXPECT_GT(rubbing, elastic);
  EXPECT_EQ(ranks.front().name, "linear maximum, constant tau");
}

TEST(FrictionComparison, IsLeftOutWithoutFriction) {
  VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  study.set_model("friction: none");
  EXPECT_TRUE(study.fit({.compare_friction = true, .profiles = {}}).models.empty());
}

}  // namespace
}  // namespace pliant
