#include "pliant/experiment/session/virtual/cord_pulls.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using Eigen::Vector3d;

// Sums of a few forces of about 1 N at distances of about 0.1 m.
constexpr double kRounding = 1e-15;

const Wrench kWrench{{1, 0.5, -0.2}, {0.01, -0.02, 0.03}};
const Vector3d kCentre(0.1, 0.05, 0.01);
const std::vector<Vector3d> kPoints{{0.11, 0, 0}, {0.12, 0.1, 0.02}};

Vector3d moment_of(const std::vector<Vector3d>& pulls) {
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 0; i < pulls.size(); ++i) moment += (kPoints[i] - kCentre).cross(pulls[i]);
  return moment;
}

TEST(CordPulls, AddUpToTheForce) {
  const auto pulls = cord_pulls(kWrench, kCentre, kPoints);
  EXPECT_LT((pulls[0] + pulls[1] - kWrench.force).norm(), kRounding);
}

TEST(CordPulls, LackOnlyTheMomentAboutTheLineBetweenThem) {
  const Vector3d line = (kPoints[1] - kPoints[0]).normalized();
  const Vector3d left = kWrench.moment - moment_of(cord_pulls(kWrench, kCentre, kPoints));
  EXPECT_LT(line.cross(left).norm(), kRounding);
  EXPECT_GT(std::abs(line.dot(left)), 1e-3) << "the wrench has a moment about the line";
}

TEST(CordPulls, DoNotPullAgainstEachOtherForNothing) {
  const auto pulls = cord_pulls(kWrench, kCentre, kPoints);
  const Vector3d line = (kPoints[1] - kPoints[0]).normalized();
  EXPECT_NEAR(line.dot(pulls[0] - pulls[1]), 0, kRounding)
      << "a pair of forces along the line would change neither force nor moment";
}

}  // namespace
}  // namespace pliant
