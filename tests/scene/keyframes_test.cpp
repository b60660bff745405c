// Vectors that change over time.

#include "pliant/scene/keyframes.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

using Eigen::Vector3d;

KeyframedVector ramp(Interpolation interpolation) {
  return {{1, 3, 4}, {{0, 0, 0}, {2, 0, 0}, {2, 0, 6}}, interpolation};
}

TEST(Keyframes, AreMetAtTheirTimes) {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::smooth}) {
    const KeyframedVector vector = ramp(interpolation);
    for (std::size_t i = 0; i < vector.times.size(); ++i) {
      EXPECT_EQ(value_at(vector, vector.times[i]), vector.values[i]);
    }
  }
}

TEST(Keyframes, HoldBeforeTheFirstAndAfterTheLast) {
  EXPECT_EQ(value_at(ramp(Interpolation::linear), -5), Vector3d(0, 0, 0));
  EXPECT_EQ(value_at(ramp(Interpolation::smooth), 100), Vector3d(2, 0, 6));
}

TEST(Keyframes, AreJoinedByStraightLines) {
  EXPECT_EQ(value_at(ramp(Interpolation::linear), 1.5), Vector3d(0.5, 0, 0));
  EXPECT_EQ(value_at(ramp(Interpolation::linear), 3.5), Vector3d(2, 0, 3));
}

TEST(Keyframes, ComeToRestWhereTheMotionIsSmooth) {
  const KeyframedVector vector = ramp(Interpolation::smooth);
  const double h = 1e-5;
  for (const double time : vector.times) {
    for (const double side : {-h, h}) {
      const Vector3d step = value_at(vector, time + side) - value_at(vector, time);
      // Cubic: 3 (h / span)^2 times the way between the keyframes.
      EXPECT_LE(step.norm(), 3 * 6 * h * h);
    }
  }
  EXPECT_EQ(value_at(vector, 2), Vector3d(1, 0, 0)) << "half way";
}

TEST(Keyframes, OfAConstantAreOne) {
  EXPECT_EQ(value_at(KeyframedVector::constant({1, 2, 3}), 17), Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace pliant
