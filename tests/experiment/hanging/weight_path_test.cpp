#include "pliant/experiment/hanging/weight_path.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/experiment/tensile/strip_pull.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/measurement/turning_points.h"

#include "support/random_laws.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;

constexpr UniaxialGeometry kSquare{0.1, 0.1, MembraneMeasure::stvk};

/// Cycles 0, 1, ... n, ... 1, 0 with growing peaks ([T] 5.3.2), each weight plus `added`.
std::vector<double> weight_cycles(int largest, double added) {
  std::vector<double> forces;
  for (int peak = 1; peak <= largest; ++peak) {
    for (int i = 0; i <= 2 * peak; ++i) forces.push_back(peak - std::abs(i - peak) + added);
  }
  return forces;
}

std::vector<char> rested_once(const std::vector<double>& forces) {
  std::vector<char> rested(forces.size(), 0);
  rested.front() = 1;
  return rested;
}

ComponentLaw table_law(double k1, double k2, double a, double b, double tau) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::affine(k1, k2);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {a, b, tau};
  return law;
}

const ComponentLaw kCotton = table_law(135.6, 64.03, 2.22, 3.16, 0.006);
const ComponentLaw kSpandex = table_law(4.42, 32.19, 0.40, 4.84, 0.088);

// Force that the strip carries in each row, its friction stress carried along the strains.
std::vector<double> carried_forces(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                   const Eigen::VectorXd& strains) {
  std::vector<double> forces;
  FrictionState state;
  for (const double strain : strains) {
    state = {strain, law.friction_stress(strain, state).stress};
    forces.push_back(force_factor(geometry, strain) * (law.elastic_stress(strain) + state.stress));
  }
  return forces;
}

TEST(WeightPath, EveryRowIsInEquilibriumWithItsWeight) {
  RandomStream random(31);
  const std::vector<double> forces = weight_cycles(6, 0.203);
  for (const MembraneMeasure measure : {MembraneMeasure::stvk, MembraneMeasure::soft_constraint}) {
    const UniaxialGeometry geometry{0.1, 0.1, measure};
    std::vector<ComponentLaw> laws{kCotton, kSpandex};
    for (int i = 0; i < 10; ++i) laws.push_back(random_law(random, CurveKind::hermite));
    laws.push_back(random_law(random, CurveKind::affine, FrictionLaw::none));
    laws.push_back(random_law(random, CurveKind::affine, FrictionLaw::constant_slope));
    for (const ComponentLaw& law : laws) {
      const auto hung = hang_weights(law, geometry, forces, rested_once(forces), false);
      ASSERT_TRUE(hung);
      const std::vector<double> carried = carried_forces(law, geometry, hung->strain);
      for (size_t i = 0; i < forces.size(); ++i) EXPECT_NEAR(carried[i], forces[i], 1e-12);
      for (Eigen::Index i = 0; i < hung->strain.size(); ++i) {
        EXPECT_NEAR(strain_at(geometry, hung->length(i)), hung->strain(i), 1e-15);  // rounding
      }
    }
  }
}

TEST(WeightPath, StopsAtTheFirstEquilibriumOnTheWay) {
  // The elastic stress rises to 10 N/m, falls to 4 and rises again: weights in between have three
  // equilibria, and which one is met depends on where the sheet comes from.
  ComponentLaw law;
  law.stiffness = ScalarCurve::hermite({0, 0.1, 0.2, 0.6}, {100, 100, 20, 60});
  const UniaxialGeometry geometry{0.1, 0.1, MembraneMeasure::soft_constraint};
  const std::vector<double> forces{0, 0.7, 1.3, 0.7, 0.2};
  const auto hung = hang_weights(law, geometry, forces, rested_once(forces), false);
  ASSERT_TRUE(hung);
  EXPECT_LT(hung->strain(1), 0.1);   // on the first rise
  EXPECT_GT(hung->strain(2), 0.25);  // has snapped through
  EXPECT_GT(hung->strain(3), 0.2);   // and stays beyond the valley
  EXPECT_LT(hung->strain(4), 0.05);  // has snapped back
  double from = 0;
  for (Eigen::Index row = 0; row < hung->strain.size(); ++row) {
    const double to = hung->strain(row), force = forces[static_cast<size_t>(row)];
    const auto excess = [&](double strain) { return 0.1 * law.elastic_stress(strain) - force; };
    const double sign = to > from ? -1 : 1;
    for (double share = 0.001; share < 0.999; share += 0.001) {
      EXPECT_GE(sign * excess(from + share * (to - from)), -1e-12) << "row " << row;
    }
    from = to;
  }
}

TEST(WeightPath, GivesNothingForAWeightThatCannotBeCarried) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(0.001);
  const std::vector<double> forces{0, 100};
  EXPECT_FALSE(hang_weights(law, kSquare, forces, rested_once(forces), false));
}

TEST(WeightPath, KeepsThePersistentStrainOfSaturatedUnloading) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(40);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {2.1, 5.41, 0.005};
  const std::vector<double> forces{0, 3, 0};
  const auto hung = hang_weights(law, kSquare, forces, rested_once(forces), false);
  ASSERT_TRUE(hung);
  // exp(-distance / tau) is what the turn leaves: below 1e-40 here.
  EXPECT_NEAR(hung->strain(2), (2.1 + 5.41 * 0.005) / (40 - 5.41), 1e-13);
  EXPECT_NEAR(hung->length(2), length_at(kSquare, hung->strain(2)), 1e-16);
}

TEST(WeightPath, StateRunsThroughRepeatsUnlessTheSheetRested) {
  std::vector<double> forces = weight_cycles(3, 0.1);
  const size_t rows = forces.size();
  forces.insert(forces.end(), forces.begin(), forces.begin() + static_cast<long>(rows));
  std::vector<char> rested = rested_once(forces);
  const auto through = hang_weights(kCotton, kSquare, forces, rested, false);
  rested[rows] = 1;
  const auto fresh = hang_weights(kCotton, kSquare, forces, rested, false);
  const auto half = static_cast<Eigen::Index>(rows);
  EXPECT_EQ(fresh->length.head(half), fresh->length.tail(half));
  EXPECT_GT(through->length(half), fresh->length(half) + 1e-4);  // a persistent length is left
}

TEST(WeightPath, TheSameWeightTwiceLeavesTheSheetAlone) {
  const std::vector<double> forces{0.2, 3.2, 3.2, 1.2, 1.2, 1.2};
  const auto hung = hang_weights(kCotton, kSquare, forces, rested_once(forces), true);
  ASSERT_TRUE(hung);
  for (const Eigen::Index row : {2, 4, 5}) {
    EXPECT_NEAR(hung->strain(row), hung->strain(row - 1), 1e-15);  // rounding of the root
    // The branch of a rounding error's direction must not show in the derivatives.
    EXPECT_LT((hung->jacobian.row(row) - hung->jacobian.row(row - 1)).norm(),
              1e-9 * hung->jacobian.row(row).norm());
  }
}

TEST(WeightPath, DerivativesAreThoseOfDifferences) {
  RandomStream random(32);
  const std::vector<double> forces = weight_cycles(4, 0.203);
  for (const FrictionLaw friction :
       {FrictionLaw::none, FrictionLaw::dahl, FrictionLaw::constant_slope}) {
    for (const CurveKind curve : {CurveKind::constant, CurveKind::affine, CurveKind::hermite}) {
      const ComponentLaw law = random_law(random, curve, friction);
      const auto hung = hang_weights(law, kSquare, forces, rested_once(forces), true);
      ASSERT_TRUE(hung);
      const VectorFunction lengths = [&](const Eigen::VectorXd& parameters) {
        return hang_weights(law.with_parameters(parameters), kSquare, forces, rested_once(forces),
                            false)
            ->length;
      };
      const DerivativeCheck check =
          check_derivatives(lengths, hung->jacobian, law.parameters(), parameter_scales(law) * 0.1);
      // Differences of lengths that are exact to rounding; a wrong term shows at 1e-3 and more.
      EXPECT_LT(check.error, 1e-7) << check.describe();
    }
  }
}

TEST(WeightPath, AStripPulledToTheseLengthsCarriesTheseWeights) {
  RandomStream random(33);
  const std::vector<double> forces = weight_cycles(5, 0);
  for (int draw = 0; draw < 20; ++draw) {
    const ComponentLaw law = draw == 0 ? kCotton : random_law(random, CurveKind::affine);
    const auto hung = hang_weights(law, kSquare, forces, rested_once(forces), false);
    ASSERT_TRUE(hung);
    const std::vector<double> lengths(hung->length.begin(), hung->length.end());
    const auto pulled = pull_strip(law, kSquare, {}, {}, lengths, half_cycles_of(lengths, 1e-9), 0);
    ASSERT_TRUE(pulled);
    for (size_t i = 0; i < forces.size(); ++i) {
      EXPECT_NEAR(pulled->force(static_cast<Eigen::Index>(i)), forces[i], 1e-12);  // rounding
    }
  }
}

}  // namespace
}  // namespace pliant
