#include "pliant/capture/repeating_texture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "capture/drawn_rig.h"
#include "capture/texture.h"

namespace pliant {
namespace {

constexpr int kPixels = 200;

Eigen::Matrix2Xd places() {
  constexpr int kRow = 16;
  Eigen::Matrix2Xd places(2, kRow * kRow);
  for (int i = 0; i < kRow * kRow; ++i) {
    places.col(i) << 20 + 10 * (i % kRow), 20 + 10 * (i / kRow);
  }
  return places;
}

GreyPicture with_noise(GreyPicture picture) {
  RandomStream random(1);
  test::add_noise(picture, 2, random);
  return picture / 255;
}

GreyPicture weave(double threads_apart) {
  return with_noise(test::drawn(kPixels, kPixels, [&](const Eigen::Vector2d& place) {
    return test::weave_at(place, threads_apart);
  }));
}

TEST(RepeatingTexture, IsFoundInWeaves) {
  for (const double apart : {3.0, 7.0, 20.0}) {
    const auto repeat = texture_repeat(weave(apart), places(), 2);
    ASSERT_TRUE(repeat) << apart;
    EXPECT_GT(repeat->correlation, 0.9) << apart;
    // The nearest place that is the same lies on the diagonal of two threads.
    const double parts = repeat->away / (std::sqrt(2.0) * apart);
    EXPECT_GT(parts, 0.9) << apart;
  }
}

TEST(RepeatingTexture, IsNotFoundInIrregularOnes) {
  const auto same = [](const Eigen::Vector2d& place) { return place; };
  EXPECT_FALSE(
      texture_repeat(with_noise(test::Texture(3).picture(kPixels, kPixels, same)), places(), 2));
  const ClothPrint print = test::print_on_square(0.05);
  GreyPicture picture(kPixels, kPixels);
  for (int row = 0; row < kPixels; ++row) {
    for (int column = 0; column < kPixels; ++column) {
      picture(row, column) =
          static_cast<float>(255 * print.at(0.25e-3 * Eigen::Vector2d(column, row)));
    }
  }
  EXPECT_FALSE(texture_repeat(with_noise(picture), places(), 2));
}

}  // namespace
}  // namespace pliant
