#include "pliant/material/density/dahl_published.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"

namespace pliant {
namespace {

using test::random_dahl;

constexpr double kRounding = 1e-13;  // a few dozen operations on numbers of order one

FrictionState random_state(RandomStream& random, const DahlParameters& dahl) {
  return {random.uniform(0, 0.4), random.uniform(-dahl.a, dahl.a)};
}

TEST(DahlPublished, IsExactForAConstantMaximum) {
  RandomStream random(1);
  for (int i = 0; i < 200; ++i) {
    DahlParameters dahl = random_dahl(random);
    dahl.b = 0;
    const FrictionState from = random_state(random, dahl);
    const double strain = random.uniform(0, 0.4);
    EXPECT_NEAR(published_friction_stress(dahl, strain, from).stress,
                friction_stress(dahl, strain, from).stress, kRounding);
  }
}

TEST(DahlPublished, DiffersFromTheExactSolutionByWhatItsOffsetBTauHasBecome) {
  RandomStream random(2);
  for (int i = 0; i < 200; ++i) {
    const DahlParameters dahl = random_dahl(random);
    const FrictionState from = random_state(random, dahl);
    const double strain = random.uniform(0, 0.4);
    const double difference = published_friction_stress(dahl, strain, from).stress -
                              friction_stress(dahl, strain, from).stress;
    const double travelled = std::abs(strain - from.strain);
    EXPECT_NEAR(difference, dahl.b * dahl.tau * (1 - std::exp(-travelled / dahl.tau)), kRounding);
    EXPECT_LE(std::abs(difference), dahl.b * dahl.tau + kRounding);
  }
}

TEST(DahlPublished, IsMirroredForNegativeStrain) {
  const DahlParameters dahl{0.4, 4.84, 0.088};
  EXPECT_EQ(published_friction_stress(dahl, -0.1, {-0.3, 0.2}).stress,
            -published_friction_stress(dahl, 0.1, {0.3, -0.2}).stress);
}

TEST(DahlPublished, AnchoredFormIsEquation54) {
  RandomStream random(3);
  for (int i = 0; i < 200; ++i) {
    const DahlParameters dahl = random_dahl(random);
    const int s = random.uniform() < 0.5 ? -1 : 1;
    const double anchor = random.uniform(0.1, 0.3);
    const double strain = anchor + s * random.uniform(0, 0.1);
    const double expected =
        s * (dahl.a + dahl.b * strain) -
        2 * s * (dahl.a + dahl.b * anchor) * std::exp(-s * (strain - anchor) / dahl.tau);
    EXPECT_NEAR(anchored_friction_stress(dahl, strain, anchor, s).stress, expected, kRounding);
  }
}

TEST(DahlPublished, AnchorsAtTheirOwnStrainAreSaturatedAgainstTheMotion) {
  const DahlParameters dahl{2.22, 3.16, 0.006};
  EXPECT_DOUBLE_EQ(anchored_friction_stress(dahl, 0.2, 0.2, 1).stress, -(2.22 + 3.16 * 0.2));
  EXPECT_DOUBLE_EQ(anchored_friction_stress(dahl, 0.2, 0.2, -1).stress, 2.22 + 3.16 * 0.2);
}

// As the exact solution does for a constant maximum, whichever side a stretch starts on.
TEST(DahlPublished, CrossesZeroStrain) {
  RandomStream random(4);
  for (int i = 0; i < 200; ++i) {
    DahlParameters dahl = random_dahl(random);
    const FrictionState from = {random.uniform(-0.4, 0.4), random.uniform(-dahl.a, dahl.a)};
    const double strain = random.uniform(-0.4, 0.4);
    const double at_zero = published_friction_stress(dahl, 0, from).stress;
    if (strain * from.strain < 0) {
      EXPECT_EQ(published_friction_stress(dahl, strain, from).stress,
                published_friction_stress(dahl, strain, {0, at_zero}).stress);
    }
    dahl.b = 0;
    EXPECT_NEAR(published_friction_stress(dahl, strain, from).stress,
                friction_stress(dahl, strain, from).stress, kRounding);
  }
}

TEST(DahlPublished, AnchoredAcrossZeroHasTheDerivativesOfDifferences) {
  const Eigen::Vector4d at(0.4, 4.84, 0.088, 0.1), scale(0.4, 4.84, 0.088, 0.1);
  const VectorFunction stress = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(
        1, anchored_friction_stress({x(0), x(1), x(2)}, -0.15, x(3), -1).stress);
  };
  const FrictionStress here = anchored_friction_stress({0.4, 4.84, 0.088}, -0.15, 0.1, -1);
  Eigen::MatrixXd gradient(1, 4);
  gradient << here.parameters[0], here.parameters[1], here.parameters[2], here.from_strain;
  const DerivativeCheck check = check_derivatives(stress, gradient, at, scale);
  EXPECT_LT(check.error, 1e-8) << check.describe();  // accuracy of the differences
}

}  // namespace
}  // namespace pliant
