// The texture printed on cloth: the same for the same seed, without waves shorter than it says,
// textured everywhere.

#include "pliant/capture/wavelet_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/capture/reference_patch.h"
#include "pliant/capture/tag_detector.h"

#include "capture/texture.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

constexpr double kPixel = 0.25e-3;  // of the camera (m)

ClothPattern cloth_of_seed(std::uint64_t seed, int octaves = 4) {
  ClothPattern cloth;
  cloth.seed = seed;
  cloth.octaves = octaves;
  return cloth;
}

/// What a camera sees of the print, 0 to 255.
GreyPicture picture_of_noise(const ClothPattern& cloth, int columns, int rows) {
  const std::vector<std::uint8_t> levels = noise_levels(cloth, columns, rows, kPixel);
  return Eigen::Map<
             const Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
             levels.data(), rows, columns)
      .cast<float>();
}

/// Power of rows, under a Hann window, by the number of waves in them.
std::vector<double> power_of_rows(const GreyPicture& picture) {
  const Eigen::Index n = picture.cols();
  const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(n, 0, static_cast<double>(n - 1));
  const Eigen::ArrayXd window =
      0.5 - 0.5 * (2 * std::numbers::pi / static_cast<double>(n) * (at + 0.5)).cos();
  std::vector<double> power;
  for (Eigen::Index waves = 0; waves < n / 2; ++waves) {
    const Eigen::ArrayXd phase =
        2 * std::numbers::pi * static_cast<double>(waves) / static_cast<double>(n) * at;
    const Eigen::MatrixXd rows = picture.cast<double>() - 127.5;
    const Eigen::VectorXd real = rows * (window * phase.cos()).matrix();
    const Eigen::VectorXd imaginary = rows * (window * phase.sin()).matrix();
    power.push_back(real.squaredNorm() + imaginary.squaredNorm());
  }
  return power;
}

/// Share of power in waves shorter than a length (pixels).
double share_of_shorter(const std::vector<double>& power, double length) {
  double all = 0, shorter = 0;
  const auto pixels = 2 * static_cast<double>(power.size());
  for (std::size_t waves = 0; waves < power.size(); ++waves) {
    all += power[waves];
    if (static_cast<double>(waves) * length > pixels) shorter += power[waves];
  }
  return shorter / all;
}

TEST(WaveletNoise, IsTheSameForTheSameSeedAlone) {
  const auto levels = [](std::uint64_t seed) {
    return noise_levels(cloth_of_seed(seed), 200, 100, kPixel);
  };
  EXPECT_EQ(levels(7), levels(7));
  EXPECT_NE(levels(7), levels(8));
}

TEST(WaveletNoise, HasNoWavesShorterThanItsFinestLength) {
  for (const int octaves : {1, 4}) {
    const ClothPattern cloth = cloth_of_seed(3, octaves);
    const auto power = power_of_rows(picture_of_noise(cloth, 512, 128));
    // 0.2 % of what a spline is; what is cut at black and white, and grey levels, add a little.
    EXPECT_LT(share_of_shorter(power, cloth.finest / kPixel), 0.004) << octaves;
    // The finest octave is there: half waves of its middle are as long.
    EXPECT_GT(share_of_shorter(power, 2 * cloth.finest / kPixel), 0.1) << octaves;
  }
}

// What is left when the coarse part is taken away has no long waves in both directions; without
// that, means of such blocks have a standard deviation of 10 grey levels in place of 1.2.
TEST(WaveletNoise, HasNoLongWavesInOneOctave) {
  constexpr int kBlock = 32, kBlocks = 20;  // 12 steps of the grid
  const GreyPicture picture =
      picture_of_noise(cloth_of_seed(9, 1), kBlock * kBlocks, kBlock * kBlocks);
  Eigen::ArrayXXf means(kBlocks, kBlocks);
  for (int r = 0; r < kBlocks; ++r) {
    for (int c = 0; c < kBlocks; ++c) {
      means(r, c) = picture.block(kBlock * r, kBlock * c, kBlock, kBlock).mean();
    }
  }
  EXPECT_LT(std::sqrt((means - means.mean()).square().mean()), 2);
}

TEST(WaveletNoise, IsMiddleGreyWithAFifthOfTheContrast) {
  const GreyPicture picture = picture_of_noise(cloth_of_seed(5), 1200, 900);
  const double mean = picture.mean(), sd = std::sqrt((picture - picture.mean()).square().mean());
  EXPECT_NEAR(mean, 127.5, 2);  // the longest waves are 64 pixels: some hundred of them
  EXPECT_NEAR(sd, 51, 2);       // of which cutting takes 0.5
  const double cut = (picture == 0 || picture == 255).cast<double>().mean();
  EXPECT_LT(cut, 0.02);
}

// What a patch promises of its match, at a noise of 2 grey levels.
TEST(WaveletNoise, HasTextureForEveryPatch) {
  constexpr int kRadius = 10, kSide = 640;
  constexpr double kNoise = 2, kEnough = 0.015;  // grey levels, pixels
  const GreyPicture picture = picture_of_noise(cloth_of_seed(11), kSide, kSide);
  const SplinePicture spline(picture, kMatchSmoothing);
  std::vector<double> promised;
  for (int row = 16; row < kSide - 16; row += 7) {
    for (int column = 16; column < kSide - 16; column += 7) {
      double along = 0, down = 0, both = 0;
      for (int dy = -kRadius; dy <= kRadius; ++dy) {
        for (int dx = -kRadius; dx <= kRadius; ++dx) {
          const Eigen::Vector2f g = spline.sample({column + dx, row + dy}).gradient;
          along += g.x() * g.x();
          down += g.y() * g.y();
          both += g.x() * g.y();
        }
      }
      const double least =
          (along + down) / 2 - std::hypot((along - down) / 2, both);  // in the worst direction
      promised.push_back(kNoise / std::sqrt(least));
    }
  }
  std::ranges::sort(promised);
  const double median = promised[promised.size() / 2], worst = promised.back();
  RecordProperty("median", std::to_string(median));
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(median, 0.007);
  EXPECT_LT(worst, kEnough);
}

/// What a camera sees of a print: the mean of what lies in each pixel, and noise.
/// @param shift  of the print to the left, in tenths of a pixel
GreyPicture photo_of(const GreyPicture& print, int shift, RandomStream& random) {
  constexpr int kFine = 10;
  const Eigen::Index rows = print.rows() / kFine, columns = print.cols() / kFine - 1;
  GreyPicture photo(rows, columns);
  for (Eigen::Index r = 0; r < rows; ++r) {
    for (Eigen::Index c = 0; c < columns; ++c) {
      photo(r, c) = print.block(kFine * r, kFine * c + shift, kFine, kFine).mean();
    }
  }
  test::add_noise(photo, 2, random);
  return photo;
}

// As the project asks of matching: bias 0.003 pixels, standard deviation 0.007.
TEST(SlowWaveletNoise, IsMatchedWithoutBias) {
  constexpr int kSide = 300, kRadius = 10;
  const ClothPattern cloth = cloth_of_seed(2);
  const auto levels = noise_levels(cloth, 10 * kSide, 10 * kSide, kPixel / 10);
  const GreyPicture print =
      Eigen::Map<const Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          levels.data(), 10 * kSide, 10 * kSide)
          .cast<float>();
  RandomStream random(3);
  const SplinePicture first(photo_of(print, 0, random), kMatchSmoothing);
  for (const int tenths : {1, 3, 5}) {
    const SplinePicture second(photo_of(print, tenths, random), kMatchSmoothing);
    std::vector<double> errors;
    for (int row = 20; row < kSide - 20; row += 10) {
      for (int column = 20; column < kSide - 20; column += 10) {
        const auto patch = ReferencePatch::of(first, Eigen::Vector2d(column, row), kRadius);
        ASSERT_TRUE(patch.has_value());
        const auto match = patch->match(second, {});
        ASSERT_TRUE(match.has_value());
        errors.push_back(match->motion.shift.x() + 0.1 * tenths);
      }
    }
    const Eigen::Map<const Eigen::ArrayXd> all(errors.data(),
                                               static_cast<Eigen::Index>(errors.size()));
    const double bias = all.mean(), sd = std::sqrt((all - bias).square().mean());
    RecordProperty("bias_" + std::to_string(tenths), std::to_string(bias));
    RecordProperty("sd_" + std::to_string(tenths), std::to_string(sd));
    EXPECT_LT(std::abs(bias), 0.003) << tenths;
    EXPECT_LT(sd, 0.007) << tenths;
  }
}

TEST(SlowWaveletNoise, ShowsNoCode) {
  constexpr int kColumns = 400, kRows = 320;
  const int pictures = test::makes_figures() ? 1000 : 40;
  RandomStream random(1);
  int phantoms = 0;
  for (int i = 0; i < pictures; ++i) {
    GreyPicture picture =
        picture_of_noise(cloth_of_seed(static_cast<std::uint64_t>(i)), kColumns, kRows) / 255;
    for (float& pixel : picture.reshaped()) {
      pixel += 0.01F * static_cast<float>(random.normal());
    }
    phantoms += static_cast<int>(detect_tags(picture).size());
  }
  EXPECT_EQ(phantoms, 0);
}

}  // namespace
}  // namespace pliant
