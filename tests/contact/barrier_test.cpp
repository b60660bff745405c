#include "pliant/contact/barrier.h"

#include <limits>

#include <gtest/gtest.h>

#include "pliant/math/check_derivatives.h"

namespace pliant {
namespace {

constexpr double kThickness = 1e-3;

TEST(Barrier, ReachesAsFarAsItsThickness) {
  EXPECT_EQ(barrier(kThickness, kThickness).slope, 0);
  EXPECT_EQ(barrier(0.02, kThickness).energy, 0);
  EXPECT_LT(barrier(0.999 * kThickness, kThickness).slope, 0);
}

TEST(Barrier, HasTheDerivativesOfItsEnergy) {
  for (const double share : {0.01, 0.1, 0.3, 0.45, 0.55, 0.8, 0.95}) {
    const double distance = share * kThickness;
    const Barrier at = barrier(distance, kThickness);
    const VectorFunction function = [](const Eigen::VectorXd& x) {
      const Barrier value = barrier(x(0), kThickness);
      return Eigen::Vector2d(value.energy, value.slope);
    };
    const DerivativeCheck check = check_derivatives(
        function, Eigen::Vector2d(at.slope, at.curvature), Eigen::VectorXd::Constant(1, distance),
        Eigen::VectorXd::Constant(1, 0.04 * distance));
    EXPECT_LT(check.error, 1e-7) << check.describe();
  }
}

TEST(Barrier, GoesOnWithoutAKinkAtHalfItsThickness) {
  const double half = kThickness / 2, step = 1e-12;
  const Barrier below = barrier(half - step, kThickness), above = barrier(half, kThickness);
  EXPECT_NEAR(below.energy, above.energy, 1e-8 * above.energy);
  EXPECT_NEAR(below.slope, above.slope, -1e-8 * above.slope);
  EXPECT_NEAR(below.curvature, above.curvature, 1e-8);
}

TEST(Barrier, IsConvexAndHasNoEnd) {
  double before = std::numeric_limits<double>::infinity();
  for (double distance = 1e-12; distance < 2 * kThickness; distance *= 1.3) {
    const Barrier at = barrier(distance, kThickness);
    EXPECT_GE(at.curvature, 0);
    EXPECT_LE(at.energy, before);
    before = at.energy;
  }
  EXPECT_GT(-barrier(1e-9, kThickness).slope, 1e5 * -barrier(kThickness / 2, kThickness).slope);
}

}  // namespace
}  // namespace pliant
