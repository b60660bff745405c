#include "pliant/contact/obstacle_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

namespace pliant {
namespace {

const std::vector<ObstacleShape> kShapes{
    HalfSpace{{0.1, 0, -0.2}, Eigen::Vector3d(0.2, -0.1, 1).normalized()},
    Sphere{{0.05, -0.1, 0.2}, 0.2}, Capsule{{-0.1, 0, 0}, {0.2, 0.1, -0.1}, 0.05},
    Box{{0.05, 0, -0.1}, {0.2, 0.1, 0.15}}};

Eigen::Vector3d random_point(RandomStream& random) {
  return {random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)};
}

TEST(ObstacleShape, HasTheDerivativesOfItsDistance) {
  RandomStream random(7);
  for (const ObstacleShape& shape : kShapes) {
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3d point = random_point(random);
      const SurfaceDistance at = surface_distance(shape, point);
      if (at.distance < 0.01) continue;
      const Eigen::Vector3d scale = Eigen::Vector3d::Constant(1e-3);
      const auto distance = [&](const Eigen::VectorXd& x) {
        return Eigen::VectorXd::Constant(1, distance_to(shape, x));
      };
      const auto normal = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return surface_distance(shape, x).normal;
      };
      const DerivativeCheck first =
          check_derivatives(distance, at.normal.transpose(), point, scale);
      const DerivativeCheck second = check_derivatives(normal, at.curvature, point, 0.1 * scale);
      EXPECT_LT(first.error, 1e-6) << shape.index() << ": " << first.describe();
      EXPECT_LT(second.error, 1e-5) << shape.index() << ": " << second.describe();
      EXPECT_NEAR(at.distance, distance_to(shape, point), 1e-15);
    }
  }
}

// Of many points on the way none before the share is nearer than what is kept, and one just after
// it is.
TEST(ObstacleShape, KnowsHowFarAPointMayGo) {
  RandomStream random(8);
  constexpr int kSamples = 2000;
  constexpr double kKept = 1e-3;
  for (const ObstacleShape& shape : kShapes) {
    int stopped = 0;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d from = random_point(random), to = random_point(random);
      if (distance_to(shape, from) <= kKept) continue;
      const double share = free_share(shape, from, to, kKept);
      const auto at = [&](double t) { return distance_to(shape, from + t * (to - from)); };
      for (int k = 0; k <= kSamples; ++k) {
        EXPECT_GE(at(share * k / kSamples), kKept * (1 - 1e-9)) << shape.index();
      }
      if (share == 1) continue;
      ++stopped;
      EXPECT_LE(at(share), kKept * 1.002) << shape.index();
    }
    EXPECT_GT(stopped, 5) << shape.index();
  }
}

}  // namespace
}  // namespace pliant
