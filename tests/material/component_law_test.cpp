#include "pliant/material/component_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/base/random.h"
#include "pliant/material/density/dahl_constant_slope.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"

namespace pliant {
namespace {

using test::random_law;
using ::testing::ElementsAre;

constexpr CurveKind kCurves[] = {CurveKind::constant, CurveKind::affine, CurveKind::hermite};
constexpr FrictionLaw kFrictions[] = {FrictionLaw::none, FrictionLaw::dahl,
                                      FrictionLaw::constant_slope};

ComponentLaw spandex() {
  ComponentLaw law;
  law.stiffness = ScalarCurve::affine(4.42, 32.19);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {0.40, 4.84, 0.088};
  return law;
}

TEST(ComponentLaw, ParametersAreStiffnessThenFriction) {
  EXPECT_THAT(spandex().parameters(), ElementsAre(4.42, 32.19, 0.40, 4.84, 0.088));
}

TEST(ComponentLaw, ParametersRoundTrip) {
  RandomStream random(1);
  for (const CurveKind curve : kCurves) {
    for (const FrictionLaw friction : kFrictions) {
      const ComponentLaw law = random_law(random, curve, friction);
      const Eigen::VectorXd other = law.parameters() * 1.5;
      const ComponentLaw changed = law.with_parameters(other);
      EXPECT_EQ(changed.parameters(), other);
      EXPECT_EQ(changed.stiffness.kind(), curve);
      EXPECT_EQ(changed.stiffness.knots(), law.stiffness.knots());
      EXPECT_EQ(changed.friction_law, friction);
    }
  }
}

TEST(ComponentLaw, RefusesTooFewParameters) {
  EXPECT_THROW(spandex().with_parameters(Eigen::VectorXd::Ones(4)), AssertionError);
}

TEST(ComponentLaw, NamesAndUnitsHaveOneEntryForEachParameter) {
  RandomStream random(2);
  for (const CurveKind curve : kCurves) {
    for (const FrictionLaw friction : kFrictions) {
      const ComponentLaw law = random_law(random, curve, friction);
      const auto count = static_cast<size_t>(law.parameter_count());
      EXPECT_EQ(parameter_names(law, "shear").size(), count);
      EXPECT_EQ(parameter_units(law, LawUnits::membrane).size(), count);
      EXPECT_EQ(parameter_units(law, LawUnits::bending).size(), count);
    }
  }
}

TEST(ComponentLaw, NamesAreThoseOfTheResults) {
  EXPECT_THAT(parameter_names(spandex(), "stretch.warp"),
              ElementsAre("stretch.warp.k1", "stretch.warp.k2", "stretch.warp.friction.a",
                          "stretch.warp.friction.b", "stretch.warp.friction.tau"));
  ComponentLaw law;
  law.stiffness = ScalarCurve::hermite({0, 0.1}, {1, 2});
  EXPECT_THAT(parameter_names(law, "shear"), ElementsAre("shear.k[0]", "shear.k[1]"));
  law.stiffness = ScalarCurve::constant(3);
  law.friction_law = FrictionLaw::constant_slope;
  EXPECT_THAT(parameter_names(law, "bend.weft"),
              ElementsAre("bend.weft.k", "bend.weft.friction.a", "bend.weft.friction.b",
                          "bend.weft.friction.alpha"));
}

TEST(ComponentLaw, UnitsFollowFromStressAndStrain) {
  EXPECT_THAT(parameter_units(spandex(), LawUnits::membrane),
              ElementsAre("N/m", "N/m", "N/m", "N/m", "1"));
  EXPECT_THAT(parameter_units(spandex(), LawUnits::bending),
              ElementsAre("N m", "N m^2", "N", "N m", "1/m"));
  ComponentLaw law = spandex();
  law.friction_law = FrictionLaw::constant_slope;
  EXPECT_EQ(parameter_units(law, LawUnits::membrane).back(), "N/m");
  EXPECT_EQ(parameter_units(law, LawUnits::bending).back(), "N m");
}

TEST(ComponentLaw, ElasticStressIsStiffnessTimesStrainAndTheTangentItsSlope) {
  EXPECT_DOUBLE_EQ(spandex().elastic_stress(0.5), (4.42 + 32.19 * 0.5) * 0.5);
  EXPECT_DOUBLE_EQ(spandex().elastic_stress(-0.1), -(4.42 + 32.19 * 0.1) * 0.1);
  RandomStream random(3);
  for (const CurveKind curve : kCurves) {
    const ComponentLaw law = random_law(random, curve);
    for (const double strain : {-0.1, 0.03, 0.21, 0.6}) {
      const VectorFunction stress = [&](const Eigen::VectorXd& x) {
        return Eigen::VectorXd::Constant(1, law.elastic_stress(x(0)));
      };
      const DerivativeCheck check = check_derivatives(
          stress, Eigen::MatrixXd::Constant(1, 1, law.elastic_tangent(strain)),
          Eigen::VectorXd::Constant(1, strain), Eigen::VectorXd::Constant(1, 0.05));
      EXPECT_LT(check.error, 1e-9) << check.describe();  // rounding of the differences
    }
  }
}

TEST(ComponentLaw, FrictionIsThatOfItsLaw) {
  ComponentLaw law = spandex();
  const FrictionState from{0.3, 0.7};
  EXPECT_EQ(law.friction_stress(0.1, from).stress,
            friction_stress(DahlParameters{0.40, 4.84, 0.088}, 0.1, from).stress);
  EXPECT_DOUBLE_EQ(law.max_friction(-0.5), 0.40 + 4.84 * 0.5);
  law.friction_law = FrictionLaw::constant_slope;
  law.friction[2] = 12;
  EXPECT_EQ(law.friction_stress(0.1, from).stress,
            friction_stress(ConstantSlopeParameters{0.40, 4.84, 12}, 0.1, from).stress);
}

TEST(ComponentLaw, WithoutFrictionThereIsNone) {
  ComponentLaw law = spandex();
  law.friction_law = FrictionLaw::none;
  EXPECT_EQ(law.parameter_count(), 2);
  EXPECT_EQ(law.max_friction(0.3), 0);
  const FrictionStress stress = law.friction_stress(0.1, {0.3, 0.7});
  EXPECT_EQ(stress.stress, 0);
  EXPECT_EQ(stress.slope, 0);
  EXPECT_EQ(stress.from_stress, 0);
}

}  // namespace
}  // namespace pliant
