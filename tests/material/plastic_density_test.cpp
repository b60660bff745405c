#include "pliant/material/density/plastic_density.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/component_law.h"
#include "pliant/material/law_path.h"

#include "support/density_samples.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

constexpr double kStiffness = 50, kYield = 0.1, kSaturation = 0.15;

/// One material point under one strain.
class Point {
 public:
  explicit Point(const PlasticParameters& plastic) : law_(0, plastic), state_(1, 1) {}

  struct Answer {
    double stress, tangent, stored, work;
  };
  Answer at(double strain) const {
    test::LaneState state = state_;
    state.strain.setConstant(strain);
    const Response response = test::response_of(law_, state);
    return {response.stress(0, 0), response.tangent(0, 0), response.stored(0), response.work(0)};
  }
  /// @return the energy that the step takes
  double step(double strain) {
    state_.strain.setConstant(strain);
    return test::advance(law_, state_)(0);
  }
  double plastic_strain() const { return state_.history(0, 0); }

 private:
  PlasticDensity law_;
  test::LaneState state_;
};

PlasticParameters unbounded() { return {kStiffness, kYield}; }
PlasticParameters saturating() { return {kStiffness, kYield, kSaturation}; }

TEST(PlasticDensity, IsElasticUpToYieldAndBearsNoMoreBeyond) {
  const Point point(unbounded());
  for (const double side : {-1.0, 1.0}) {
    EXPECT_DOUBLE_EQ(point.at(side * 0.07).stress, side * 0.07 * kStiffness);
    EXPECT_EQ(point.at(side * 0.07).tangent, kStiffness);
    EXPECT_EQ(point.at(side * 0.07).work, 0);
    EXPECT_DOUBLE_EQ(point.at(side * 0.4).stress, side * kYield * kStiffness);
    EXPECT_EQ(point.at(side * 0.4).tangent, 0);
    EXPECT_DOUBLE_EQ(point.at(side * 0.4).work, kStiffness * kYield * (0.4 - kYield));
  }
}

// The limit of plastic strain is [T] Fig. 2.2's centre: elastic, yielding, and elastic again.
TEST(PlasticDensity, OfSaturationIsElasticAgainBeyondIt) {
  Point point(saturating());
  EXPECT_EQ(point.at(0.2).tangent, 0);
  EXPECT_EQ(point.at(0.4).tangent, kStiffness);
  EXPECT_DOUBLE_EQ(point.at(0.4).stress, kStiffness * (0.4 - kSaturation));
  point.step(0.4);
  EXPECT_EQ(point.plastic_strain(), kSaturation);
  EXPECT_EQ(point.at(0.1).tangent, kStiffness);  // back to where it yields the other way
  EXPECT_EQ(point.at(0.0).tangent, 0);
  point.step(-1);
  EXPECT_EQ(point.plastic_strain(), -kSaturation);
}

/// What random steps of the density are compared with.
std::vector<double> path(unsigned seed, int count) {
  RandomStream random(seed);
  return test::random_strains(random, count, -0.4, 0.4);
}

// Classical return mapping of linear kinematic hardening ([SimoHughes1998] chapter 1): an elastic
// range k and a stiffness h in parallel are E = h + k with H = h E / k, which has E H / (E + H) =
// h.
TEST(PlasticDensity, BesideAStiffnessIsLinearKinematicHardening) {
  constexpr double kBeside = 20, kSum = kBeside + kStiffness;
  constexpr double kHardening = kBeside * kSum / kStiffness, kYieldStress = kYield * kSum;
  const ComponentLaw law{ScalarCurve::constant(kBeside),
                         FrictionLaw::none,
                         {},
                         {{*find_addend_kind("plastic"), Eigen::Vector2d(kStiffness, kYield)}}};
  EXPECT_EQ(law.stiffness_at_rest(), kSum);
  LawPath carried(law, {});
  double plastic = 0;
  for (const double strain : path(3, 40)) {
    const double trial = kSum * (strain - plastic) - kHardening * plastic;
    if (const double over = std::abs(trial) - kYieldStress; over > 0) {
      plastic += std::copysign(over / (kSum + kHardening), trial);
    }
    EXPECT_NEAR(carried.at(strain).stress, kSum * (strain - plastic), 1e-13 * kSum);
    carried.turn_at(strain, {});
  }
}

TEST(PlasticDensity, LeavesTheSameHoweverAWayIsDivided) {
  for (const PlasticParameters& plastic : {unbounded(), saturating()}) {
    Point whole(plastic), divided(plastic);
    double last = 0;
    for (const double strain : path(5, 40)) {
      const double work = whole.step(strain);
      double sum = 0;
      for (int i = 1; i <= 7; ++i) sum += divided.step(last + (strain - last) * i / 7);
      last = strain;
      EXPECT_NEAR(divided.plastic_strain(), whole.plastic_strain(), 1e-15);
      EXPECT_NEAR(sum, work, 1e-14);
    }
  }
}

// The trapezoidal rule is exact but for the steps with a corner in them: second order.
TEST(PlasticDensity, StoresOrTakesAllWorkThatIsDoneOnIt) {
  constexpr int kSteps = 4000;
  for (const PlasticParameters& plastic : {unbounded(), saturating()}) {
    Point point(plastic);
    double last = 0, done = 0, taken = 0;
    for (const double to : path(7, 12)) {
      const double from = last;
      for (int i = 1; i <= kSteps; ++i) {
        const double strain = from + (to - from) * i / kSteps;
        done += (point.at(last).stress + point.at(strain).stress) / 2 * (strain - last);
        const double work = point.step(strain);
        EXPECT_GE(work, 0);
        taken += work;
        last = strain;
      }
    }
    EXPECT_NEAR(point.at(last).stored + taken, done, 1e-6 * done);
  }
}

TEST(PlasticDensity, AnswersAnAcceptedStepAsBeforeItWasAccepted) {
  for (const PlasticParameters& plastic : {unbounded(), saturating()}) {
    Point point(plastic);
    for (const double strain : path(9, 40)) {
      const Point::Answer before = point.at(strain);
      point.step(strain);
      const Point::Answer after = point.at(strain);
      EXPECT_EQ(after.stress, before.stress);
      EXPECT_EQ(after.stored, before.stored);
      EXPECT_EQ(after.work, 0);
      // The stiffer of the two directions that lie ahead.
      EXPECT_EQ(after.tangent, kStiffness);
    }
  }
}

// A step is a minimisation: its energy may not have two lowest points, nor a force that jumps.
TEST(PlasticDensity, HasAConvexPotentialWithoutCorners) {
  RandomStream random(11);
  for (const PlasticParameters& plastic : {unbounded(), saturating()}) {
    Point point(plastic);
    const auto potential = [&](double strain) {
      const Point::Answer answer = point.at(strain);
      return answer.stored + answer.work;
    };
    for (const double strain : path(13, 40)) {
      point.step(strain);
      const double a = random.uniform(-0.5, 0.5), b = random.uniform(-0.5, 0.5);
      EXPECT_LE(potential((a + b) / 2), (potential(a) + potential(b)) / 2 + 1e-15);
      EXPECT_LE(std::abs(point.at(a).stress - point.at(b).stress),
                kStiffness * std::abs(a - b) * (1 + 1e-12));
    }
  }
}

TEST(PlasticDensity, TakesAParallelogramOnALoop) {
  for (const PlasticParameters& plastic : {unbounded(), saturating()}) {
    for (const double reach : {0.07, 0.2, 0.5}) {
      Point point(plastic);
      point.step(reach);
      const double half = std::clamp(reach - kYield, 0.0, plastic.saturation);
      EXPECT_NEAR(point.step(-reach) + point.step(reach), 4 * kStiffness * kYield * half, 1e-14);
    }
  }
}

}  // namespace
}  // namespace pliant
