#include "pliant/contact/coulomb.h"

#include <gtest/gtest.h>

#include "pliant/math/check_derivatives.h"

namespace pliant {
namespace {

const Eigen::Vector3d kNormal = Eigen::Vector3d(1, 2, 3).normalized();
const Eigen::Matrix3d kPlane = Eigen::Matrix3d::Identity() - kNormal * kNormal.transpose();
const Eigen::Vector3d kAlong = (kPlane * Eigen::Vector3d(1, 0.3, -2)).normalized();
constexpr double kBound = 0.02;

TEST(SlipEnergy, HasTheForceAndTheHessianOfItsEnergy) {
  for (const double length : {0.3, 0.9, 1.1, 4.0}) {
    const Eigen::Vector3d slip = length * kSlipLength * kAlong;
    const SlipEnergy at = slip_energy(slip, kBound, kPlane);
    const Eigen::Vector3d scale = Eigen::Vector3d::Constant(0.3 * kSlipLength);
    const auto energy = [](const Eigen::VectorXd& x) {
      return Eigen::VectorXd::Constant(1, slip_energy(kPlane * x, kBound, kPlane).energy);
    };
    const auto force = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      return slip_energy(kPlane * x, kBound, kPlane).force;
    };
    const DerivativeCheck first = check_derivatives(energy, at.force.transpose(), slip, scale);
    const DerivativeCheck second = check_derivatives(force, at.hessian, slip, scale);
    EXPECT_LT(first.error, 1e-6) << length << ": " << first.describe();
    EXPECT_LT(second.error, 1e-6) << length << ": " << second.describe();
  }
}

TEST(SlipEnergy, NeverExceedsTheCone) {
  for (const double length : {0.0, 0.5, 1.0, 2.0, 1e6}) {
    const Eigen::Vector3d slip = length * kSlipLength * kAlong;
    EXPECT_LE(slip_energy(slip, kBound, kPlane).force.norm(), kBound * (1 + 1e-12));
  }
  EXPECT_NEAR(slip_energy(kAlong, kBound, kPlane).force.dot(kAlong), kBound, 1e-12);
}

TEST(SlipEnergy, KeepsOfASlipWhatIsElastic) {
  const Eigen::Vector3d small = 0.4 * kSlipLength * kAlong;
  EXPECT_EQ(elastic_slip(small), small);
  EXPECT_TRUE(elastic_slip(3 * kAlong).isApprox(kSlipLength * kAlong));
}

}  // namespace
}  // namespace pliant
