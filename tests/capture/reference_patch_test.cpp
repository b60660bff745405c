#include "pliant/capture/reference_patch.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "capture/texture.h"

namespace pliant {
namespace {

using test::add_noise;
using test::Texture;

constexpr int kSize = 160, kRadius = 10;

GreyPicture seen(const Texture& texture, const Eigen::Vector2d& shift,
                 const Eigen::Matrix2d& slope = Eigen::Matrix2d::Zero()) {
  const Eigen::Matrix2d back = (Eigen::Matrix2d::Identity() + slope).inverse();
  const Eigen::Vector2d middle = Eigen::Vector2d::Constant(kSize / 2);
  return texture.picture(kSize, kSize, [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
    return middle + back * (place - middle - shift);
  });
}

std::vector<Eigen::Vector2d> places() {
  std::vector<Eigen::Vector2d> places;
  for (int y = 30; y <= kSize - 30; y += 10) {
    for (int x = 30; x <= kSize - 30; x += 10) places.emplace_back(x, y);
  }
  return places;
}

TEST(ReferencePatch, IsFoundToAThousandthOfAPixel) {
  const Texture texture(1);
  const SplinePicture reference(seen(texture, {0, 0}));
  for (const Eigen::Vector2d& shift :
       {Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(-0.5, 0.37), Eigen::Vector2d(1.8, -1.3)}) {
    const SplinePicture moved(seen(texture, shift));
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places()) {
      const auto patch = ReferencePatch::of(reference, place, kRadius);
      ASSERT_TRUE(patch);
      const auto match = patch->match(moved, {});
      ASSERT_TRUE(match) << place.transpose();
      EXPECT_LT((match->motion.shift - shift).norm(), 5e-3) << place.transpose();
      EXPECT_GT(match->correlation, 0.999);
      sum += match->motion.shift - shift;
    }
    EXPECT_LT(sum.norm() / static_cast<double>(places().size()), 1e-3);
  }
}

TEST(ReferencePatch, IsFoundWhereItIsStretchedAndTurned) {
  const Texture texture(2);
  Eigen::Matrix2d slope;
  slope << 0.06, -0.04, 0.05, -0.03;
  const SplinePicture reference(seen(texture, {0, 0})), moved(seen(texture, {0.4, -0.2}, slope));
  const auto patch = ReferencePatch::of(reference, Eigen::Vector2d::Constant(kSize / 2), kRadius);
  const auto match = patch->match(moved, {});
  ASSERT_TRUE(match);
  EXPECT_LT((match->motion.shift - Eigen::Vector2d(0.4, -0.2)).norm(), 2e-3);
  EXPECT_LT((match->motion.slope - slope).norm(), 1e-3);
}

TEST(ReferencePatch, IsFoundInAnotherLight) {
  const Texture texture(3);
  const GreyPicture plain = seen(texture, {0.3, 0.6});
  const SplinePicture reference(seen(texture, {0, 0})), moved(plain), dim(0.4F * plain + 90);
  for (const Eigen::Vector2d& place : places()) {
    const auto patch = ReferencePatch::of(reference, place, kRadius);
    const auto match = patch->match(moved, {}), in_dim = patch->match(dim, {});
    ASSERT_TRUE(match && in_dim);
    EXPECT_LT((match->motion.shift - in_dim->motion.shift).norm(), 1e-4);
  }
}

// The covariance is that of many draws of the noise, and the noise is told too.
TEST(ReferencePatch, KnowsHowUncertainItIs) {
  const Texture texture(4);
  RandomStream random(11);
  constexpr double kNoise = 2;
  double squares = 0, noise = 0;
  int count = 0;
  const GreyPicture first = seen(texture, {0, 0}), second = seen(texture, {0.4, 0.2});
  for (int draw = 0; draw < 12; ++draw) {
    GreyPicture reference = first, moved = second;
    add_noise(reference, kNoise, random);
    add_noise(moved, kNoise, random);
    const SplinePicture reference_spline(reference, kMatchSmoothing);
    const SplinePicture moved_spline(moved, kMatchSmoothing);
    for (const Eigen::Vector2d& place : places()) {
      const auto match =
          ReferencePatch::of(reference_spline, place, kRadius)->match(moved_spline, {});
      ASSERT_TRUE(match);
      const Eigen::Vector2d off = match->motion.shift - Eigen::Vector2d(0.4, 0.2);
      squares += off.dot(match->covariance.inverse() * off);
      noise += match->noise;
      count += 1;
    }
  }
  EXPECT_NEAR(noise / count, kNoise, 0.03 * kNoise);
  EXPECT_NEAR(squares / (2 * count), 1, 0.15);
}

TEST(ReferencePatch, IsNoneWithoutTexture) {
  const SplinePicture flat(GreyPicture::Constant(60, 60, 100));
  EXPECT_FALSE(ReferencePatch::of(flat, {30, 30}, kRadius));
}

TEST(ReferencePatch, IsNoneOfStripesAlone) {
  GreyPicture stripes(60, 60);
  for (int column = 0; column < 60; ++column) {
    stripes.col(column) = static_cast<float>(100 + 40 * std::cos(0.7 * column));
  }
  EXPECT_FALSE(ReferencePatch::of(SplinePicture(stripes), {30, 30}, kRadius));
}

TEST(ReferencePatch, IsNoneBeyondThePicture) {
  const SplinePicture reference(seen(Texture(5), {0, 0}));
  EXPECT_FALSE(ReferencePatch::of(reference, {9, 30}, kRadius));
  EXPECT_TRUE(ReferencePatch::of(reference, {10, 30}, kRadius));
  const auto patch = ReferencePatch::of(reference, {12, 30}, kRadius);
  PatchMotion out;
  out.shift.x() = -5;
  EXPECT_FALSE(patch->match(reference, out));
}

}  // namespace
}  // namespace pliant
