#include "pliant/material/density/dahl.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "material/friction_reference.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::integrate_friction;
using test::random_dahl;
using test::random_strains;

constexpr int kPaths = 60;
constexpr int kTurns = 8;
constexpr double kRounding = 1e-13;  // a few dozen operations on numbers of order one

/// States of a material point that starts at rest and passes through the strains.
std::vector<FrictionState> states_along(const DahlParameters& dahl,
                                        const std::vector<double>& strains) {
  std::vector<FrictionState> states{{strains.front(), 0}};
  for (size_t i = 1; i < strains.size(); ++i) {
    states.push_back({strains[i], friction_stress(dahl, strains[i], states.back()).stress});
  }
  return states;
}

/// Work of the friction stress along one monotone stretch, from [T] Eq. 5.2 itself:
/// sigma = s (sigma_max - tau d sigma / d strain), and sigma_max integrates in closed form.
double work(const DahlParameters& dahl, const FrictionState& from, const FrictionState& to) {
  const double s = to.strain < from.strain ? -1 : 1;
  const auto max_stress_integral = [&](double x) {
    return dahl.a * x + dahl.b * x * std::abs(x) / 2;
  };
  return s * (max_stress_integral(to.strain) - max_stress_integral(from.strain) -
              dahl.tau * (to.stress - from.stress));
}

/// S = tau sigma^2 / (2 sigma_max), which no path can take more than is given back.
double stored(const DahlParameters& dahl, const FrictionState& state) {
  return dahl.tau * state.stress * state.stress / (2 * max_friction_stress(dahl, state.strain));
}

FrictionState saturated(const DahlParameters& dahl, double strain) {
  return {strain, dahl.a + dahl.b * strain - dahl.b * dahl.tau};
}

TEST(Dahl, SolvesItsEquationAlongRandomPathsThroughZero) {
  RandomStream random(1);
  for (int path = 0; path < kPaths; ++path) {
    const DahlParameters dahl = random_dahl(random);
    const auto rate = [&](double strain, double stress, double s) {
      return (dahl.a + dahl.b * std::abs(strain) - s * stress) / dahl.tau;
    };
    FrictionState state;
    for (const double strain : random_strains(random, kTurns, -0.4, 0.4)) {
      const double expected = integrate_friction(rate, state, strain, dahl.tau / 100);
      const double stress = friction_stress(dahl, strain, state).stress;
      // The integration is wrong by about (1/100)^4 / 120 of the stress.
      EXPECT_NEAR(stress, expected, 1e-9 * max_friction_stress(dahl, strain));
      state = {strain, stress};
    }
  }
}

TEST(Dahl, WithConstantMaximumIsTheFirstOrderResponse) {
  const DahlParameters dahl{2.22, 0, 0.006};
  for (const double strain : {0.001, 0.004, 0.03}) {
    const double decay = std::exp(-strain / dahl.tau);
    EXPECT_NEAR(friction_stress(dahl, strain, {}).stress, dahl.a * (1 - decay), kRounding);
    EXPECT_NEAR(friction_stress(dahl, -strain, {}).stress, -dahl.a * (1 - decay), kRounding);
  }
}

TEST(Dahl, TwoMonotoneStepsAreOne) {
  RandomStream random(2);
  for (int i = 0; i < 200; ++i) {
    const DahlParameters dahl = random_dahl(random);
    const FrictionState from{random.uniform(-0.3, 0.3), random.uniform(-dahl.a, dahl.a)};
    const double end = random.uniform(-0.3, 0.3);
    const double middle = from.strain + random.uniform() * (end - from.strain);
    const double at_middle = friction_stress(dahl, middle, from).stress;
    EXPECT_NEAR(friction_stress(dahl, end, {middle, at_middle}).stress,
                friction_stress(dahl, end, from).stress, kRounding * 10);
  }
}

TEST(Dahl, IsOddInStrain) {
  RandomStream random(3);
  for (int i = 0; i < 100; ++i) {
    const DahlParameters dahl = random_dahl(random);
    const FrictionState from{random.uniform(-0.3, 0.3), random.uniform(-dahl.a, dahl.a)};
    const double strain = random.uniform(-0.3, 0.3);
    const FrictionStress stress = friction_stress(dahl, strain, from);
    const FrictionStress mirrored = friction_stress(dahl, -strain, {-from.strain, -from.stress});
    EXPECT_EQ(mirrored.stress, -stress.stress);
    EXPECT_EQ(mirrored.slope, stress.slope);
  }
}

TEST(Dahl, AStretchOfNoLengthKeepsTheStressAndHasTheLoadingSlope) {
  const DahlParameters dahl{0.4, 4.84, 0.088};
  const FrictionStress still = friction_stress(dahl, 0.2, {0.2, 0.3});
  EXPECT_DOUBLE_EQ(still.stress, 0.3);
  EXPECT_NEAR(still.slope, (dahl.a + dahl.b * 0.2 - 0.3) / dahl.tau, kRounding);
}

TEST(Dahl, StaysOnItsSaturatedBranches) {
  const DahlParameters dahl{0.4, 4.84, 0.088};
  const double offset = dahl.b * dahl.tau;
  const double up = friction_stress(dahl, 0.5, saturated(dahl, 0.1)).stress;
  EXPECT_NEAR(up, dahl.a + dahl.b * 0.5 - offset, kRounding);
  const FrictionState unloading{0.5, -(dahl.a + dahl.b * 0.5) - offset};
  const FrictionStress down = friction_stress(dahl, 0.1, unloading);
  EXPECT_NEAR(down.stress, -(dahl.a + dahl.b * 0.1) - offset, kRounding);
  EXPECT_NEAR(down.slope, -dahl.b, kRounding);
}

TEST(Dahl, SlopeIsNeverBelowMinusB) {
  RandomStream random(4);
  for (int path = 0; path < kPaths; ++path) {
    const DahlParameters dahl = random_dahl(random);
    FrictionState state;
    for (const double strain : random_strains(random, 4 * kTurns, -0.4, 0.4)) {
      const FrictionStress stress = friction_stress(dahl, strain, state);
      EXPECT_GE(stress.slope, -dahl.b - kRounding);
      state = {strain, stress.stress};
    }
  }
}

TEST(Dahl, LagsItsMaximumByAtMostBTau) {
  RandomStream random(5);
  for (int path = 0; path < kPaths; ++path) {
    const DahlParameters dahl = random_dahl(random);
    for (const FrictionState& state :
         states_along(dahl, random_strains(random, 4 * kTurns, -0.4, 0.4))) {
      EXPECT_LE(std::abs(state.stress),
                max_friction_stress(dahl, state.strain) + dahl.b * dahl.tau + kRounding);
    }
  }
}

TEST(Dahl, WorkIsAtLeastTheChangeOfWhatIsStored) {
  RandomStream random(6);
  int checked = 0;
  while (checked < kPaths) {
    const DahlParameters dahl = random_dahl(random);
    if (dahl.b * dahl.tau > 2 * dahl.a) continue;
    ++checked;
    const std::vector<FrictionState> states =
        states_along(dahl, random_strains(random, 4 * kTurns, -0.3, 0.3));
    double total = 0;
    for (size_t i = 1; i < states.size(); ++i) {
      total += work(dahl, states[i - 1], states[i]);
      // Rounding of a sum of some thirty terms of order one.
      EXPECT_GE(total, stored(dahl, states[i]) - stored(dahl, states[0]) - 1e-12);
    }
  }
}

TEST(Dahl, AClosedStrainCycleMayReturnWork) {
  const DahlParameters dahl{2.1, 0, 0.031};
  const FrictionState from = saturated(dahl, 0.2);
  const std::vector<FrictionState> back{
      from, {0.2 - dahl.tau, friction_stress(dahl, 0.2 - dahl.tau, from).stress}};
  const FrictionState end{0.2, friction_stress(dahl, 0.2, back[1]).stress};
  const double total = work(dahl, from, back[1]) + work(dahl, back[1], end);
  const double e = std::exp(1.0);
  EXPECT_NEAR(total, (-2 + 6 / e - 2 / (e * e)) * dahl.a * dahl.tau, kRounding);
  EXPECT_NEAR(total / (dahl.a * dahl.tau), -0.06, 0.005);
}

// Where k strain + friction = 0 on the unloading branch from a saturated, large strain.
double persistent_strain(const DahlParameters& dahl, double stiffness) {
  const FrictionState from = saturated(dahl, 40 * dahl.tau + 0.5);
  double low = 0, high = from.strain;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const bool above = stiffness * middle + friction_stress(dahl, middle, from).stress > 0;
    (above ? high : low) = middle;
  }
  return low;
}

TEST(Dahl, SaturatedUnloadingLeavesThePersistentStrain) {
  const double k = 26.62;
  const DahlParameters growing{2.1, 5.41, 0.031};
  const DahlParameters constant{2.1, 0, 0.031};
  // What the exponential has left of the turn: exp(-(0.5 + 40 tau) / tau), beyond rounding.
  EXPECT_NEAR(persistent_strain(growing, k),
              (growing.a + growing.b * growing.tau) / (k - growing.b), kRounding);
  EXPECT_NEAR(persistent_strain(constant, k), constant.a / k, kRounding);
}

TEST(Dahl, RepeatedCyclesCloseToTheTanhLoop) {
  const DahlParameters dahl{2.1, 0, 0.031};
  const double low = 0.05, high = 0.09;
  FrictionState state{low, 0};
  FrictionState top;
  for (int cycle = 0; cycle < 40; ++cycle) {
    top = {high, friction_stress(dahl, high, state).stress};
    state = {low, friction_stress(dahl, low, top).stress};
  }
  const double amplitude = dahl.a * std::tanh((high - low) / (2 * dahl.tau));
  EXPECT_NEAR(top.stress, amplitude, kRounding);
  EXPECT_NEAR(state.stress, -amplitude, kRounding);
  EXPECT_NEAR(work(dahl, state, top) + work(dahl, top, state),
              2 * (dahl.a * (high - low) - 2 * dahl.tau * amplitude), kRounding);
}

TEST(Dahl, LoopsOfAGrowingMaximumLoseTheAreaBetweenTheirBranches) {
  const DahlParameters dahl{0.4, 4.84, 0.088};
  const FrictionState bottom{0.1, friction_stress(dahl, 0.1, saturated(dahl, 0.6)).stress};
  const FrictionState top{0.6, friction_stress(dahl, 0.6, bottom).stress};
  const FrictionState closed{0.1, friction_stress(dahl, 0.1, top).stress};
  // Simpson's rule over the difference of the branches.
  constexpr int kIntervals = 2000;
  const double h = (top.strain - bottom.strain) / kIntervals;
  double area = 0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double strain = bottom.strain + i * h;
    const double gap =
        friction_stress(dahl, strain, bottom).stress - friction_stress(dahl, strain, top).stress;
    area += gap * h / 3 * (i == 0 || i == kIntervals ? 1 : (i % 2 == 1 ? 4 : 2));
  }
  // Simpson's error: (h / tau)^4 / 180 of the area.
  EXPECT_NEAR(work(dahl, bottom, top) + work(dahl, top, closed), area, 1e-9 * area);
}

TEST(Dahl, StaysFiniteOverStretchesOfManyTau) {
  const DahlParameters dahl{2.22, 3.16, 1e-4};
  const FrictionStress far = friction_stress(dahl, 5, {-5, -2});
  EXPECT_NEAR(far.stress, dahl.a + dahl.b * (5 - dahl.tau), 1e-12);
  for (const double derivative : far.parameters) EXPECT_TRUE(std::isfinite(derivative));
  EXPECT_EQ(far.from_stress, 0);
}

}  // namespace
}  // namespace pliant
