// What strain takes away for good, what it shifts, and what relaxes with time.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "pliant/material/density/maxwell_density.h"
#include "pliant/material/density/rate_friction.h"
#include "pliant/material/density/set_density.h"
#include "pliant/material/density/softening_density.h"

#include "support/density_samples.h"

namespace pliant {
namespace {

/// One material point under one strain.
class Point {
 public:
  explicit Point(const Density& law) : law_(law), state_(1, law.history_size()) {}

  Response at(double strain, double seconds = 1) const {
    test::LaneState state = state_;
    state.strain.setConstant(strain);
    return test::response_of(law_, state, {.seconds = seconds});
  }
  double stress(double strain, double seconds = 1) const {
    return at(strain, seconds).stress(0, 0);
  }
  /// @return the energy that the step takes
  double step(double strain, double seconds = 1) {
    state_.strain.setConstant(strain);
    return test::advance(law_, state_, {.seconds = seconds})(0);
  }
  double stored() const {
    Lane stored = Lane::Zero();
    law_.add_stored(state_.samples(), stored);
    return stored(0);
  }

 private:
  const Density& law_;
  test::LaneState state_;
};

/// Friction after a way of one strain that takes some time, in many steps.
double saturated(const Density& law, double seconds, int steps = 2000) {
  Point point(law);
  for (int i = 1; i <= steps; ++i) {
    point.step(static_cast<double>(i) / steps, seconds / steps);
  }
  return point.stress(1 + 1e-9, seconds / steps);
}

TEST(RateFriction, GrowsByAShareWithEachDecadeOfTheRate) {
  constexpr double kGrowth = 0.05;
  const RateFriction law(0, {2, 0, 0.01, kGrowth});
  const double decade = 2 * kGrowth * std::log(10);
  const double slow = saturated(law, 1000), fast = saturated(law, 100), faster = saturated(law, 10);
  EXPECT_NEAR(fast - slow, decade, 0.01 * decade);
  EXPECT_NEAR(faster - fast, decade, 0.01 * decade);
}

TEST(RateFriction, IsDahlsWhereAllIsSlow) {
  const RateFriction law(0, {2, 1, 0.01, 0.05});
  const DahlFriction dahl(0, DahlParameters{2, 1, 0.01});
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(saturated(law, endless), saturated(dahl, endless));
}

// A step takes the rate of the one before: what that misses falls with the length of the steps.
TEST(RateFriction, ComesToOneStressWhereStepsAreCut) {
  const RateFriction law(0, {2, 0, 0.2, 0.2});
  const double limit = saturated(law, 50, 64000);
  const double coarse = std::abs(saturated(law, 50, 500) - limit);
  const double fine = std::abs(saturated(law, 50, 1000) - limit);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(MaxwellDensity, LetsAHeldStressFallToOneEth) {
  const MaxwellDensity law(0, 50, 3);
  Point point(law);
  point.step(0.1, 1e-9);
  EXPECT_NEAR(point.stress(0.1, 1e-9), 5, 1e-6);
  EXPECT_NEAR(point.stress(0.1, 3), 5 * std::exp(-1), 1e-6);
  EXPECT_EQ(point.stress(0.1, std::numeric_limits<double>::infinity()), 0);
}

// A step is exact at a constant rate, so that it may be cut in any way.
TEST(MaxwellDensity, DoesNotDependOnHowAnEvenWayIsCut) {
  const MaxwellDensity law(0, 50, 2);
  Point whole(law), cut(law);
  whole.step(0.4, 5);
  for (int i = 1; i <= 40; ++i) cut.step(0.01 * i, 0.125);
  EXPECT_NEAR(whole.stress(0.4, 1e-12), cut.stress(0.4, 1e-12), 1e-9);
  // The dashpot's stress tends to k time rate.
  EXPECT_NEAR(whole.stress(0.4, 1e-12), 50 * 2 * 0.08 * -std::expm1(-2.5), 1e-9);
}

TEST(MaxwellDensity, LosesWhatAHeldStressStored) {
  const MaxwellDensity law(0, 50, 2);
  Point point(law);
  point.step(0.2, 1e-9);
  const double stored = point.stored();
  EXPECT_NEAR(stored, 25 * 0.04, 1e-6);
  EXPECT_NEAR(point.step(0.2, 100), stored, 1e-9);
  EXPECT_NEAR(point.stored(), 0, 1e-12);
}

TEST(SofteningDensity, ReturnsOnALineAndGoesOnWhereItLeft) {
  const SofteningDensity law(0, 40, 0.3);
  Point point(law);
  const auto first = [](double strain) { return 40 * strain * std::exp(-strain / 0.3); };
  EXPECT_NEAR(point.stress(0.2), first(0.2), 1e-13);
  point.step(0.2);
  EXPECT_NEAR(point.stress(0.1), first(0.2) / 2, 1e-13);
  EXPECT_NEAR(point.stress(-0.2), -first(0.2), 1e-13);
  point.step(0);
  EXPECT_NEAR(point.stress(0.2), first(0.2), 1e-13);
  EXPECT_NEAR(point.stress(0.35), first(0.35), 1e-13);
}

TEST(SofteningDensity, TakesTheEnergyOfTheLinksThatBreakAndNoMore) {
  const SofteningDensity law(0, 40, 0.3);
  Point point(law);
  const double lost = point.step(0.25);
  // The work of the way there, by the midpoint rule.
  double work = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double strain = 0.25 * (i + 0.5) / 20'000;
    work += 40 * strain * std::exp(-strain / 0.3) * 0.25 / 20'000;
  }
  EXPECT_NEAR(lost + point.stored(), work, 1e-8);
  EXPECT_GT(lost, 0);
  EXPECT_EQ(point.step(-0.1), 0);
  EXPECT_EQ(point.step(0.25), 0);
}

TEST(SetDensity, IsFeltOnTheWayBackAlone) {
  const SetDensity law(0, 30);
  for (const double side : {-1.0, 1.0}) {
    Point point(law);
    EXPECT_EQ(point.stress(side * 0.2), 0);
    EXPECT_EQ(point.step(side * 0.2), 0);
    EXPECT_NEAR(point.stress(side * 0.08), -side * 30 * 0.12, 1e-13);
    EXPECT_EQ(point.at(side * 0.1).tangent(0, 0), 30);
    EXPECT_EQ(point.step(side * 0.1), 0);
    EXPECT_NEAR(point.stress(side * 0.2), 0, 1e-13);
    EXPECT_EQ(point.at(side * 0.3).tangent(0, 0), 0);
  }
}

TEST(SetDensity, TakesTheWorkThatMovesItsRestToTheOtherSide) {
  const SetDensity law(0, 30);
  Point point(law);
  const double lost = point.step(0.2) + point.step(-0.1);
  // Back with the slope 30, from 0 at 0.2 to -6 at rest; on at -6.
  EXPECT_NEAR(lost + point.stored(), 6 * 0.2 / 2 + 6 * 0.1, 1e-12);
}

}  // namespace
}  // namespace pliant
