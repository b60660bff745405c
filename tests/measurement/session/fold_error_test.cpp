#include "pliant/measurement/session/fold_error.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

constexpr double kSide = 0.1, kAmplitude = 0.004, kWavelength = 0.025;

/// A square sheet with a wrinkle along weft on a shallow dome, turned in space.
Session wrinkled(double amplitude, double wavelength, double phase, double turn = 0.7) {
  Session session;
  session.sample = {"", kSide, kSide, {}, 0.2};
  session.rest = regular_grid(kSide, kSide, 41, 41);
  SessionFrame frame;
  frame.positions = session.rest.positions;
  for (auto point : frame.positions.colwise()) {
    const double u = point.x() - kSide / 2, v = point.y() - kSide / 2;
    point.z() = 2 * u * u - v * v + u * v +
                amplitude * std::sin(2 * std::numbers::pi * u / wavelength + phase);
  }
  const Pose pose{
      Eigen::Quaterniond(Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 2, -1).normalized())),
      {0.1, -0.2, 0.3 * turn}};
  frame.positions = posed(pose, frame.positions);
  session.frames = {frame};
  return session;
}

const Session kWrinkle = wrinkled(kAmplitude, kWavelength, 0);
/// Of a wrinkle that is not there.
const FoldError kAll = fold_error(kWrinkle, wrinkled(0, kWavelength, 0));

TEST(FoldError, OfEqualShapesIsZeroWhereverTheyAre) {
  const FoldError same = fold_error(kWrinkle, kWrinkle);
  EXPECT_EQ(same.height, 0);
  EXPECT_EQ(same.slope, 0);
  const FoldError moved = fold_error(kWrinkle, wrinkled(kAmplitude, kWavelength, 0, -0.4));
  EXPECT_LT(moved.height, 1e-12);
  EXPECT_LT(moved.slope, 1e-10);
}

TEST(FoldError, OfAFlatPredictionIsTheWrinklesOwnHeightAndSlope) {
  // Root mean squares of a sine; slopes on straight pieces between the 10 nodes of a wave are
  // sin(pi / 10) / (pi / 10) of a sine's. What is normal to the dome and not to its middle: 1 %.
  EXPECT_NEAR(kAll.height, kAmplitude / std::sqrt(2), 0.05 * kAll.height);
  const double slope = 2 * std::numbers::pi * kAmplitude / kWavelength / std::sqrt(2);
  EXPECT_NEAR(kAll.slope, 0.984 * slope, 0.05 * slope);
}

TEST(FoldError, HardlySeesThatAWrinkleIsShifted) {
  for (const double phase : {0.5, 1.0, std::numbers::pi / 2, 2.0, std::numbers::pi}) {
    const Session shifted = wrinkled(kAmplitude, kWavelength, phase);
    const FoldError error = fold_error(kWrinkle, shifted);
    // Windows at the rim have no whole number of waves; what a quadratic takes off differs.
    EXPECT_LT(error.height, 0.1 * kAll.height) << phase;
    EXPECT_LT(error.slope, 0.1 * kAll.slope) << phase;
  }
  // The distance of the nodes is that of two wrinkles that have nothing in common.
  const Session opposite = wrinkled(kAmplitude, kWavelength, std::numbers::pi);
  const double rms = (opposite.frames[0].positions - kWrinkle.frames[0].positions).norm() / 41;
  EXPECT_NEAR(rms, 2 * kAmplitude / std::sqrt(2), 0.05 * kAmplitude);
}

TEST(FoldError, GrowsWithTheDifferenceOfAmplitudes) {
  for (const double part : {0.25, 0.5, 0.75, 1.5, 2.0}) {
    const FoldError error = fold_error(kWrinkle, wrinkled(part * kAmplitude, kWavelength, 1.0));
    // The shift by 1 rad adds its few per cent.
    EXPECT_NEAR(error.height, std::abs(part - 1) * kAll.height, 0.08 * kAll.height) << part;
    EXPECT_NEAR(error.slope, std::abs(part - 1) * kAll.slope, 0.08 * kAll.slope) << part;
  }
}

TEST(FoldError, SeesAnotherWavelengthInTheSlope) {
  double before = 0;
  for (const double part : {0.9, 0.75, 0.5}) {
    const FoldError error = fold_error(kWrinkle, wrinkled(kAmplitude, part * kWavelength, 0));
    EXPECT_LT(error.height, 0.1 * kAll.height) << part;
    EXPECT_GT(error.slope, before + 0.05 * kAll.slope) << part;
    before = error.slope;
  }
  EXPECT_GT(before, 0.8 * kAll.slope) << "of half the wavelength: twice the slope";
}

}  // namespace
}  // namespace pliant::test
