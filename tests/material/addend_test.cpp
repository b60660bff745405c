#include "pliant/material/addend/addend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/component_law.h"
#include "pliant/material/law_path.h"

#include "support/added_stiffness.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::added_stiffness;
using ::testing::ElementsAre;

Addend branch(double a, double b, double tau) {
  return {*find_addend_kind("dahl"), Eigen::Vector3d(a, b, tau)};
}

TEST(AddendRegistry, KnowsEveryKindByItsNameAndWhatAFitNeedsOfIt) {
  for (const AddendKind* kind : addend_kinds()) {
    EXPECT_EQ(find_addend_kind(kind->name), kind);
    EXPECT_FALSE(kind->description.empty()) << kind->name;
    EXPECT_FALSE(kind->starts.empty()) << kind->name;
    bool scales = false;
    for (const AddendParameter& parameter : kind->parameters) {
      EXPECT_FALSE(parameter.meaning.empty()) << kind->name << " " << parameter.name;
      EXPECT_GT(parameter.step, 0) << kind->name << " " << parameter.name;
      scales = scales || parameter.scales;
    }
    EXPECT_TRUE(scales) << kind->name << ": a linear start has nothing to look for";
    for (const std::vector<double>& start : kind->starts) {
      ASSERT_EQ(start.size(), kind->parameters.size()) << kind->name;
    }
  }
  EXPECT_EQ(find_addend_kind("no such law"), nullptr);
}

// The stress of a law is told to be proportional to some of its numbers: it must be.
TEST(AddendRegistry, StressesScaleAsTheKindsSay) {
  for (const AddendKind* kind : addend_kinds()) {
    Eigen::VectorXd values(std::ssize(kind->parameters));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      values(i) = kind->starts.front()[static_cast<std::size_t>(i)];
    }
    const Addend addend(*kind, values);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(addend.history_size());
    EXPECT_NEAR(addend.scaled(3).at(0.2, 0, rest).stress, 3 * addend.at(0.2, 0, rest).stress,
                1e-13 * std::abs(addend.at(0.2, 0, rest).stress))
        << kind->name;
  }
}

// A simulation without internal friction leaves out what stores nothing, and that alone; what flows
// has let go where all is at rest.
TEST(AddendRegistry, FrictionStoresNothingAndElasticRangesDo) {
  for (const AddendKind* kind : addend_kinds()) {
    const Eigen::VectorXd values = Eigen::VectorXd::Constant(std::ssize(kind->parameters), 0.1);
    const Addend addend(*kind, values);
    if (addend.is_elastic()) continue;
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(addend.history_size());
    const Eigen::VectorXd reached = addend.advanced(0.3, 0, rest);
    const bool has_none = addend.is_friction() || addend.flows();
    EXPECT_EQ(addend.at(0.05, 0.3, reached).stored == 0, has_none) << kind->name;
    EXPECT_TRUE(!has_none || addend.range_stiffness() == 0) << kind->name;
  }
}

TEST(ComponentLaw, CountsElasticRangesAsStiffnessAtRestAndNotAsFriction) {
  const Addend range(*find_addend_kind("plastic"), Eigen::Vector2d(12, 0.1));
  const ComponentLaw law{ScalarCurve::constant(30),
                         FrictionLaw::dahl,
                         {1, 0, 0.1},
                         {branch(1, 0, 0.1), range, {added_stiffness(), Eigen::Vector2d(5, 0)}}};
  EXPECT_EQ(law.stiffness_at_rest(), 47);
  EXPECT_EQ(law.elastic_tangent(0), 35);
  const ComponentLaw smooth = law.without_friction();
  EXPECT_EQ(smooth.friction_law, FrictionLaw::none);
  EXPECT_EQ(smooth.addends.size(), 2u);
  EXPECT_EQ(smooth.stiffness_at_rest(), 47);
}

TEST(Addend, OfABranchOfFrictionAnswersAsFrictionDoes) {
  const DahlParameters dahl{1.2, 3, 0.05};
  const FrictionStress expected = friction_stress(dahl, 0.07, FrictionState{0.1, 0.4});
  const Addend addend = branch(1.2, 3, 0.05);
  const Eigen::VectorXd history = Eigen::VectorXd::Constant(1, 0.4);
  EXPECT_NEAR(addend.at(0.07, 0.1, history).stress, expected.stress, 1e-14);
  EXPECT_NEAR(addend.at(0.07, 0.1, history).tangent, expected.slope, 1e-12);
  EXPECT_NEAR(addend.advanced(0.07, 0.1, history)(0), expected.stress, 1e-14);
}

TEST(Addend, SecondsOfAKindAreNumbered) {
  const std::vector<Addend> addends{
      branch(1, 0, 0.1), branch(2, 0, 0.2), {added_stiffness(), Eigen::Vector2d(1, 2)}};
  EXPECT_THAT(parameter_names(addends),
              ElementsAre("dahl.a", "dahl.b", "dahl.tau", "dahl2.a", "dahl2.b", "dahl2.tau",
                          "added.k1", "added.k2"));
}

TEST(Addend, UnitsFollowThePowersOfStressAndStrain) {
  const auto unit = [](int stress, int strain, bool bending) {
    return unit_of({.name = "", .meaning = "", .stress = stress, .strain = strain},
                   bending ? LawUnits::bending : LawUnits::membrane);
  };
  EXPECT_EQ(unit(1, -1, false), "N/m");
  EXPECT_EQ(unit(0, -2, false), "1");
  EXPECT_EQ(unit(1, 0, true), "N");
  EXPECT_EQ(unit(1, -1, true), "N m");
  EXPECT_EQ(unit(1, -2, true), "N m^2");
  EXPECT_EQ(unit(0, 1, true), "1/m");
  EXPECT_EQ(unit(0, -2, true), "m^2");
  const AddendParameter modulus{.name = "", .meaning = "", .stress = 1, .strain = -1};
  EXPECT_EQ(unit_of(modulus, LawUnits::solid), "Pa");
}

TEST(ComponentLaw, AddsElasticAddendsToItsStiffness) {
  const ComponentLaw law{ScalarCurve::affine(30, 8),
                         FrictionLaw::none,
                         {},
                         {{added_stiffness(), Eigen::Vector2d(12, 5)}}};
  const ComponentLaw sum{ScalarCurve::affine(42, 13)};
  for (const double strain : {-0.3, 0.0, 0.2}) {
    EXPECT_NEAR(law.elastic_stress(strain), sum.elastic_stress(strain), 1e-14);
    EXPECT_NEAR(law.elastic_tangent(strain), sum.elastic_tangent(strain), 1e-13);
    EXPECT_NEAR(law.elastic_energy(strain), sum.elastic_energy(strain), 1e-14);
    EXPECT_NEAR(law.elastic_secant(strain), sum.elastic_secant(strain), 1e-13);
    const Eigen::VectorXd by = law.elastic_gradient(strain);
    EXPECT_NEAR(by(0), by(2), 1e-14);
    EXPECT_NEAR(by(1), by(3), 1e-14);
  }
  EXPECT_EQ(law.with_parameters(law.parameters()).parameters(), law.parameters());
}

TEST(ComponentLaw, OfAddendsAloneHasTheirParameters) {
  const ComponentLaw law{ScalarCurve::none(), FrictionLaw::none, {}, {branch(1, 2, 0.1)}};
  EXPECT_THAT(parameter_names(law, "shear"),
              ElementsAre("shear.dahl.a", "shear.dahl.b", "shear.dahl.tau"));
  EXPECT_TRUE(law.remembers());
  EXPECT_EQ(law.elastic_stress(0.1), 0);
  EXPECT_EQ(law.elastic_part().parameter_count(), 0);
}

// Two branches with the same numbers are one of twice the strength, wherever they stand.
TEST(LawPath, CarriesAddendsThatRememberAsItCarriesFriction) {
  const ComponentLaw one{ScalarCurve::constant(40), FrictionLaw::dahl, {2.4, 6, 0.05}};
  const ComponentLaw two{
      ScalarCurve::constant(40), FrictionLaw::dahl, {1.2, 3, 0.05}, {branch(1.2, 3, 0.05)}};
  LawPath single(one, {}), parallel(two, {});
  for (const double turn : {0.2, 0.05, 0.3, -0.1, 0.15}) {
    EXPECT_NEAR(parallel.at(turn).stress, single.at(turn).stress, 1e-13);
    EXPECT_NEAR(parallel.stress_at(turn), single.stress_at(turn), 1e-13);
    EXPECT_NEAR(parallel.at(turn).slope, single.at(turn).slope, 1e-11);
    single.turn_at(turn, {});
    parallel.turn_at(turn, {});
  }
}

}  // namespace
}  // namespace pliant
