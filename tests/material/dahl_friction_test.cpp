#include "pliant/material/density/dahl_friction.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"

#include "support/density_samples.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::advance;
using test::LaneState;
using test::random_dahl;
using test::response_of;

constexpr double kRounding = 1e-13;

DahlBySide random_sides(RandomStream& random) {
  const DahlParameters positive = random_dahl(random);
  return {positive, random_dahl(random)};
}

/// Steps of eight points, every second one through zero; some points stand still.
void draw_step(RandomStream& random, LaneState& state) {
  for (double& strain : state.strain.reshaped()) {
    const double draw = random.uniform();
    if (draw < 0.1) continue;  // stays where it is
    strain = draw < 0.2 ? 0 : random.uniform(-0.4, 0.4);
  }
}

/// S = tau sigma^2 / (2 sigma_max), which no path can take more than is given back.
double stored(const DahlParameters& dahl, double strain, double stress) {
  return dahl.tau * stress * stress / (2 * max_friction_stress(dahl, strain));
}

TEST(DahlFriction, IsTheScalarFrictionStressInEveryLane) {
  RandomStream random(1);
  for (int path = 0; path < 40; ++path) {
    const DahlBySide dahl = random_sides(random);
    const DahlFriction law(0, dahl);
    LaneState state(1, 1);
    for (int step = 0; step < 30; ++step) {
      draw_step(random, state);
      const LaneState before = state;
      const Response response = response_of(law, state);
      const Lane work = advance(law, state);
      for (int lane = 0; lane < kLanes; ++lane) {
        const FrictionState from{before.last(lane, 0), before.history(lane, 0)};
        const FrictionStress expected =
            friction_stress(dahl, before.strain(lane, 0), from).friction;
        const double expected_work = friction_work(dahl, before.strain(lane, 0), from);
        // The lanes take the exponential of vector instructions.
        EXPECT_NEAR(response.stress(lane, 0), expected.stress, 10 * kRounding);
        EXPECT_NEAR(response.work(lane), expected_work, 10 * kRounding);
        EXPECT_EQ(response.stored(lane), 0);
        EXPECT_NEAR(state.history(lane, 0), expected.stress, 10 * kRounding);
        EXPECT_NEAR(work(lane), expected_work, 10 * kRounding);
        if (before.strain(lane, 0) != before.last(lane, 0)) {
          EXPECT_NEAR(response.tangent(lane, 0), expected.slope, 1e-9 * dahl.positive.a);
        }
      }
    }
  }
}

/// A state that stands still at a strain and a friction stress.
LaneState standing(double strain, double stress) {
  LaneState state(1, 1);
  state.strain.setConstant(strain);
  state.last = state.before = state.strain;
  state.history.setConstant(stress);
  return state;
}

TEST(DahlFriction, HasTheStifferSlopeWhereItStandsStill) {
  const DahlParameters dahl{0.4, 4.84, 0.088};
  const DahlFriction law(0, dahl);
  for (const double strain : {0.2, -0.2, 0.0}) {
    for (const double stress : {0.3, -0.3, 0.0}) {
      const Response response = response_of(law, standing(strain, stress));
      const double expected = (max_friction_stress(dahl, strain) + std::abs(stress)) / dahl.tau;
      EXPECT_NEAR(response.tangent(0, 0), expected, kRounding * 100);
      EXPECT_NEAR(response.stress(0, 0), stress, kRounding);
      EXPECT_EQ(response.work(0), 0);
    }
  }
}

TEST(DahlFriction, HasTheStifferSlopeOfBothSidesAtZeroStrain) {
  const DahlParameters stiff{3, 0.5, 0.03}, soft{1, 0.5, 0.03};
  for (const double stress : {0.4, -0.4}) {
    const LaneState state = standing(0, stress);
    EXPECT_NEAR(response_of(DahlFriction(0, DahlBySide{stiff, soft}), state).tangent(0, 0),
                (stiff.a - stress) / stiff.tau, kRounding * 100);
    EXPECT_NEAR(response_of(DahlFriction(0, DahlBySide{soft, stiff}), state).tangent(0, 0),
                (stiff.a + stress) / stiff.tau, kRounding * 100);
  }
}

// One linear system a step relies on it: the parabola with that slope is never below the work.
TEST(DahlFriction, IsMajorisedByTheParabolaOfItsStifferSlope) {
  RandomStream random(5);
  for (int draw = 0; draw < 100; ++draw) {
    DahlParameters dahl = random_dahl(random);
    dahl.b = 0;
    const DahlFriction law(0, dahl);
    const double strain = random.uniform(-0.2, 0.2), stress = random.uniform(-1, 1) * dahl.a;
    LaneState state = standing(strain, stress);
    const double slope = response_of(law, state).tangent(0, 0);
    for (int lane = 0; lane < kLanes; ++lane) {
      state.strain(lane, 0) += random.uniform(-4, 4) * dahl.tau;
    }
    const Lane way = (state.strain - state.last).col(0);
    const Response response = response_of(law, state);
    EXPECT_LE((response.work - way * (stress + slope * way / 2)).maxCoeff(), 10 * kRounding);
  }
}

TEST(DahlFriction, NeverHasATangentBelowMinusB) {
  RandomStream random(2);
  for (int path = 0; path < 60; ++path) {
    const DahlParameters dahl = random_dahl(random);
    const DahlFriction law(0, dahl);
    LaneState state(1, 1);
    for (int step = 0; step < 40; ++step) {
      draw_step(random, state);
      EXPECT_GE(response_of(law, state).tangent.minCoeff(), -dahl.b - 100 * kRounding);
      advance(law, state);
    }
  }
}

// The stress that one side leaves may be above the other side's maximum, and falls to it.
TEST(DahlFriction, MayFallFasterWherePassingToASideOfLessFriction) {
  const DahlParameters rough{3, 0.5, 0.03}, smooth{1, 0.5, 0.03};
  const DahlFriction law(0, DahlBySide{smooth, rough});
  LaneState state(1, 1);
  state.last.setConstant(-0.3);
  state.before.setConstant(-0.4);
  state.history.setConstant(rough.a + rough.b * (0.3 + rough.tau));  // saturated
  state.strain.setConstant(1e-9);
  const double expected = (smooth.a - rough.a - rough.b * rough.tau) / smooth.tau;
  EXPECT_NEAR(response_of(law, state).tangent(0, 0), expected, 1e-5);
}

TEST(DahlFriction, IsConvexInStrainWithoutGrowth) {
  RandomStream random(3);
  for (int draw = 0; draw < 100; ++draw) {
    DahlParameters dahl = random_dahl(random);
    dahl.b = 0;
    const DahlFriction law(0, dahl);
    LaneState state(1, 1);
    state.last.setConstant(random.uniform(-0.2, 0.2));
    state.history.setConstant(random.uniform(-1, 1) * dahl.a);
    // Stresses along increasing strains, the last accepted one among them, never fall.
    for (int lane = 0; lane < kLanes; ++lane) {
      state.strain(lane, 0) = state.last(lane, 0) + 0.3 * dahl.tau * (lane - 3);
    }
    const Response response = response_of(law, state);
    for (int lane = 1; lane < kLanes; ++lane) {
      EXPECT_GE(response.stress(lane, 0), response.stress(lane - 1, 0) - kRounding);
    }
  }
}

TEST(DahlFriction, TakesAtLeastTheWorkThatItsStressStores) {
  RandomStream random(4);
  int checked = 0;
  while (checked < 60) {
    const DahlParameters dahl = random_dahl(random);
    if (dahl.b * dahl.tau > 2 * dahl.a) continue;
    ++checked;
    const DahlFriction law(0, dahl);
    LaneState state(1, 1);
    Lane work = Lane::Zero();
    for (int step = 0; step < 60; ++step) {
      draw_step(random, state);
      work += advance(law, state);
      for (int lane = 0; lane < kLanes; ++lane) {
        // Sixty terms of order one.
        EXPECT_GE(work(lane),
                  stored(dahl, state.last(lane, 0), state.history(lane, 0)) - 60 * kRounding);
      }
    }
  }
}

/// At a large strain, long after the last turn.
LaneState saturated(const Density& law, const DahlParameters& dahl, double strain,
                    int friction = 0) {
  LaneState state(1, law.history_size());
  state.strain.setConstant(strain);
  state.last = state.before = state.strain;
  state.history.col(friction).setConstant(dahl.a + dahl.b * strain - dahl.b * dahl.tau);
  return state;
}

TEST(DahlFriction, ReturnsWorkInACycleFromSaturation) {
  const DahlParameters dahl{2.1, 0, 0.031};
  const DahlFriction law(0, dahl);
  LaneState state = saturated(law, dahl, 0.2);
  state.strain -= dahl.tau;
  double work = advance(law, state)(0);
  state.strain += dahl.tau;
  work += advance(law, state)(0);
  const double e = std::exp(1.0);
  EXPECT_NEAR(work, (-2 + 6 / e - 2 / (e * e)) * dahl.a * dahl.tau, kRounding);
  EXPECT_NEAR(work / (dahl.a * dahl.tau), -0.06, 0.005);
}

/// The strain without stress that unloading in steps of `step` comes to, by bisection within the
/// step in which the stress changes its sign.
double persistent_strain(const Density& law, LaneState state, double step) {
  for (;;) {
    state.strain = state.last - step;
    if (response_of(law, state).stress(0, 0) <= 0) break;
    advance(law, state);
  }
  double low = state.strain(0, 0), high = state.last(0, 0);
  for (int i = 0; i < 60; ++i) {
    state.strain.setConstant((low + high) / 2);
    (response_of(law, state).stress(0, 0) > 0 ? high : low) = state.strain(0, 0);
  }
  return low;
}

TEST(DahlFriction, LeavesThePersistentStrainHoweverItIsUnloaded) {
  const double k = 26.62;
  for (const DahlParameters& dahl :
       {DahlParameters{2.1, 5.41, 0.031}, DahlParameters{2.1, 0, 0.031}}) {
    Sum law;
    law.add_addend(std::make_unique<StiffnessDensity>(0, ScalarCurve::constant(k)));
    law.add_addend(std::make_unique<DahlFriction>(0, dahl));
    const double strain = 0.5 + 40 * dahl.tau;  // so far that exp(-strain / tau) is rounding
    for (const double step : {0.003, 0.05, 3.0}) {
      EXPECT_NEAR(persistent_strain(law, saturated(law, dahl, strain), step),
                  (dahl.a + dahl.b * dahl.tau) / (k - dahl.b), 1e-12)
          << "b = " << dahl.b << ", step " << step;
    }
  }
}

TEST(DahlFriction, ListsTheParametersOfTheSidesThatDiffer) {
  const DahlParameters one{1, 2, 0.03}, other{4, 5, 0.06};
  Eigen::VectorXd same(3), different(6);
  same << 1, 2, 0.03;
  different << 1, 2, 0.03, 4, 5, 0.06;
  EXPECT_EQ(DahlFriction(0, one).parameters(), same);
  EXPECT_EQ(DahlFriction(0, DahlBySide{one, other}).parameters(), different);
}

}  // namespace
}  // namespace pliant
