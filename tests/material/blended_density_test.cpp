// Laws of heterogeneous materials: sums of the laws of samples by weight, however they are taken.

#include "pliant/material/density/blended_density.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/density/closed_form_density.h"
#include "pliant/material/density/rubber_energies.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"
#include "pliant/math/check_derivatives.h"

#include "material/quasi_static_step.h"

namespace pliant {
namespace {

constexpr int kSamples = 5;

/// Two strains: a spline energy and a polynomial, linear in their numbers; or Ogden's, which is
/// not.
std::shared_ptr<const ParametricDensity> law(RandomStream& random, bool linear) {
  auto sum = std::make_shared<Sum>();
  sum->add_addend(std::make_shared<StiffnessDensity>(
      0, ScalarCurve::spline({-0.1, 0.1}, {random.uniform(1, 9), random.uniform(1, 9)})));
  if (linear) {
    sum->add_addend(std::make_shared<ClosedFormDensity>(
        1, polynomial_energy, Eigen::Vector3d(random.uniform(1, 5), random.uniform(-1, 1), 0.3),
        true));
  } else {
    sum->add_addend(std::make_shared<ClosedFormDensity>(
        1, ogden_energy, Eigen::Vector2d(random.uniform(1, 5), random.uniform(1, 4))));
  }
  return sum;
}

BlendedDensity::Laws laws(RandomStream& random, bool linear) {
  BlendedDensity::Laws all;
  for (int k = 0; k < kSamples; ++k) all.push_back(law(random, linear));
  return all;
}

test::LaneState state(RandomStream& random) {
  test::LaneState state(2, 0);
  state.weights.resize(kLanes, kSamples);
  for (double& x : state.strain.reshaped()) x = random.uniform(0.12, 0.4);
  for (double& x : state.weights.reshaped()) x = random.uniform(0, 1);
  state.weights.col(2).setZero();
  state.weights.colwise() /= state.weights.rowwise().sum().eval();
  return state;
}

TEST(BlendedDensity, IsTheWeightedSumOfItsSamples) {
  RandomStream random(5);
  for (const bool linear : {true, false}) {
    const BlendedDensity::Laws all = laws(random, linear);
    const test::LaneState at = state(random);
    Response sum(2);
    for (int k = 0; k < kSamples; ++k) {
      const Response own = test::response_of(*all[static_cast<size_t>(k)], at);
      const Lane weight = at.weights.col(k);
      sum.stored += weight * own.stored;
      sum.stress += own.stress.colwise() * weight;
      sum.tangent += own.tangent.colwise() * weight;
    }
    for (const bool alike : {true, false}) {
      const BlendedDensity blended(all, alike);
      EXPECT_EQ(blended.is_linear(), linear && alike);
      const Response own = test::response_of(blended, at);
      EXPECT_TRUE(own.stored.isApprox(sum.stored, 1e-13));
      EXPECT_TRUE(own.stress.isApprox(sum.stress, 1e-13));
      EXPECT_TRUE(own.tangent.isApprox(sum.tangent, 1e-13));
    }
  }
}

TEST(BlendedDensity, DerivativesByTheNumbersOfEachSampleAreThoseOfFiniteDifferences) {
  RandomStream random(6);
  for (const bool linear : {true, false}) {
    const BlendedDensity blended(laws(random, linear), true);
    const test::LaneState at = state(random);
    for (int lane = 0; lane < kLanes; ++lane) {
      const test::QuasiStaticStep step(blended, at, lane, 0.01);
      const DerivativeCheck check =
          check_derivatives(step, step.stated(), step.arguments(), step.scale());
      EXPECT_LT(check.error, 1e-8) << check.describe();
    }
  }
}

}  // namespace
}  // namespace pliant
