// The curvature that the points of a measured profile show.

#include "pliant/experiment/profile/profile_curvature.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kLength = 0.1;  // m

/// Points of a line whose curvature grows from one end to the other, equally far apart along it.
ProfileRows clothoid(double first, double last, int count, double noise = 0) {
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, noise > 0 ? noise : 1);
  ProfileRows profile;
  constexpr int kSteps = 20000;
  Eigen::Vector2d position(0, 0);
  for (int i = 0; i <= kSteps; ++i) {
    if (i % (kSteps / (count - 1)) == 0) {
      Eigen::Vector2d seen = position;
      if (noise > 0 && i > 0) seen += Eigen::Vector2d(error(random), error(random));
      profile.points.push_back(seen);
    }
    const double s = kLength * (i + 0.5) / kSteps;
    const double angle = first * s + (last - first) * s * s / (2 * kLength);
    position += kLength / kSteps * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return profile;
}

double largest_error(const ProfileRows& profile, double first, double last) {
  const std::vector<double> curvature = profile_curvature(profile, kLength);
  double largest = 0;
  for (size_t i = 0; i < curvature.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(curvature.size() - 1);
    largest = std::max(largest, std::abs(curvature[i] - (first + share * (last - first))));
  }
  return largest;
}

TEST(ProfileCurvature, OfAGentleBendIsFound) {
  EXPECT_LT(largest_error(clothoid(-20, 0, 21), -20, 0), 0.05);
}

// Five turns, four points a turn.
TEST(ProfileCurvature, OfATightSpiralIsFoundFromFewPoints) {
  EXPECT_LT(largest_error(clothoid(300, 330, 21), 300, 330), 0.3);
}

TEST(ProfileCurvature, IsLittleDisturbedByNoise) {
  EXPECT_LT(largest_error(clothoid(40, 80, 26, 1e-4), 40, 80), 8);
}

// Points that are 1.7 mm apart and each a third of a millimetre off.
TEST(ProfileCurvature, IsLittleDisturbedByNoiseOfDensePoints) {
  EXPECT_LT(largest_error(clothoid(40, 80, 65, 3.5e-4), 40, 80), 16);
}

}  // namespace
}  // namespace pliant
