#include "pliant/capture/spline_picture.h"

#include <gtest/gtest.h>

#include "capture/texture.h"

namespace pliant {
namespace {

using test::Texture;

GreyPicture still(int columns, int rows) {
  return Texture(7).picture(columns, rows, [](const Eigen::Vector2d& place) { return place; });
}

TEST(SplinePicture, PassesThroughThePixels) {
  const GreyPicture picture = still(23, 17);
  const SplinePicture spline(picture);
  EXPECT_EQ(spline.columns(), 23);
  EXPECT_EQ(spline.rows(), 17);
  for (int row = 0; row < 17; ++row) {
    for (int column = 0; column < 23; ++column) {
      EXPECT_NEAR(spline.value(Eigen::Vector2d(column, row)), picture(row, column), 2e-3)
          << row << ", " << column;
    }
  }
}

// Halfway between pixels the waves of six pixels are met to a hundredth of the contrast.
TEST(SplinePicture, MeetsASmoothPictureBetweenItsPixels) {
  const SplinePicture spline(still(60, 60));
  const Texture texture(7);
  RandomStream random(1);
  double sum = 0;
  constexpr int kPlaces = 500;
  for (int i = 0; i < kPlaces; ++i) {
    const Eigen::Vector2d place(random.uniform(10, 49), random.uniform(10, 49));
    const double missed = spline.value(place) - texture.at(place);
    sum += missed * missed;
  }
  EXPECT_LT(std::sqrt(sum / kPlaces), 0.01 * 40);
}

TEST(SplinePicture, GradientIsThatOfDifferences) {
  const SplinePicture spline(still(40, 30));
  RandomStream random(2);
  constexpr double kStep = 0.02;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d place(random.uniform(1, 38), random.uniform(1, 28));
    const PictureSample sample = spline.sample(place);
    EXPECT_EQ(sample.value, spline.value(place));
    for (const int axis : {0, 1}) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const double expected =
          (spline.value(place + step) - spline.value(place - step)) / (2 * kStep);
      EXPECT_NEAR(sample.gradient(axis), expected, 0.05) << place.transpose();
    }
  }
}

TEST(SplinePicture, KnowsWhatItTakesFromTheNoise) {
  RandomStream random(3);
  GreyPicture noise = GreyPicture::Zero(300, 300);
  test::add_noise(noise, 1, random);
  for (const double smoothing : {0.0, 0.125}) {
    const SplinePicture spline(noise, smoothing);
    for (const double off : {0.0, 0.2, 0.5, 0.7}) {
      double sum = 0;
      for (int row = 20; row < 280; ++row) {
        for (int column = 20; column < 280; ++column) {
          const double value = spline.value(Eigen::Vector2d(column + off, row + 0.3));
          sum += value * value;
        }
      }
      EXPECT_NEAR(sum / (260 * 260), spline.noise_left({off, 0.3}), 0.02) << off;
    }
  }
  EXPECT_NEAR(SplinePicture(noise).noise_left({3, 8}), 1, 1e-6);
}

TEST(SplinePicture, KnowsWhatIsInIt) {
  const SplinePicture spline(still(8, 6));
  EXPECT_TRUE(spline.contains({0, 0}));
  EXPECT_TRUE(spline.contains({7, 5}));
  EXPECT_FALSE(spline.contains({7.01, 2}));
  EXPECT_FALSE(spline.contains({3, -0.01}));
}

}  // namespace
}  // namespace pliant
