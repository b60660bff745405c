// Weights of the samples of heterogeneous solids.

#include "pliant/mechanics/solid_field.h"

#include <gtest/gtest.h>

#include "support/solid_bodies.h"

namespace pliant {
namespace {

using test::field_of;

TEST(SolidField, WeightsAreNormalisedGaussians) {
  const SolidField field = field_of({1, 2, 5});
  EXPECT_NEAR(field.width, 0.1, 1e-15);
  const Eigen::Vector3d place(0.1, 0.02, 0.07);
  const Eigen::VectorXd weights = field.weights_at(place);
  EXPECT_NEAR(weights.sum(), 1, 1e-15);
  EXPECT_NEAR(weights(0), weights(1), 1e-15);  // as far away
  const double further = 0.15 * 0.15 - 0.05 * 0.05;
  EXPECT_NEAR(weights(2) / weights(0), std::exp(-further / (2 * 0.1 * 0.1)), 1e-14);
  EXPECT_NEAR(field.density_at(place), 1000 * weights.dot(Eigen::Vector3d(1, 2, 5)), 1e-9);
  EXPECT_NEAR(field.weights_at({1e3, 0, 0})(2), 1, 1e-12);  // far away from all
}

}  // namespace
}  // namespace pliant
