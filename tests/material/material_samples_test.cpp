// Weights of the samples of heterogeneous materials, and the laws blended by them.

#include "pliant/material/material_samples.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/solid_bodies.h"

namespace pliant {
namespace {

TEST(MaterialSamples, WeightsAreNormalisedGaussians) {
  const MaterialSamples samples = test::rubber_along_x({1, 2, 5}).samples;
  const Eigen::Vector3d place(0.1, 0.02, 0.07);
  const Eigen::VectorXd weights = weights_at(samples, place);
  EXPECT_NEAR(weights.sum(), 1, 1e-15);
  EXPECT_NEAR(weights(0), weights(1), 1e-15);  // as far away
  const double further = 0.15 * 0.15 - 0.05 * 0.05;
  EXPECT_NEAR(weights(2) / weights(0), std::exp(-further / (2 * 0.1 * 0.1)), 1e-14);
  EXPECT_NEAR(weights_at(samples, {1e3, 0, 0})(2), 1, 1e-12);  // far away from all
}

}  // namespace
}  // namespace pliant
