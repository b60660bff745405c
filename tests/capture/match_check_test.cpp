// What matches are worth, on a texture that moves to where it is known to be.
#include "pliant/capture/match_check.h"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "capture/texture.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

constexpr int kPixels = 240;
constexpr double kNoise = 2;  // grey levels of 256

GreyPicture with_noise(GreyPicture picture, std::uint64_t seed) {
  RandomStream random(seed);
  test::add_noise(picture, kNoise, random);
  return picture / 255;
}

/// The texture stretched by 6 % and turned there and back.
/// @param way  0 to 1, there; 1 to 2, back
GreyPicture on_the_way(const test::Texture& texture, double way, std::uint64_t seed) {
  const double part = 1 - std::abs(1 - way);
  const Eigen::Vector2d middle(kPixels / 2.0, kPixels / 2.0);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.1 * part).toRotationMatrix();
  const Eigen::Matrix2d to = turn * Eigen::DiagonalMatrix<double, 2>(1 + 0.06 * part, 1);
  const Eigen::Matrix2d from = to.inverse();
  return with_noise(texture.picture(kPixels, kPixels,
                                    [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
                                      return middle + from * (place - middle);
                                    }),
                    seed);
}

PatchTracker tracker_of(GreyPicture first) {
  RunContext context;
  context.threads = 2;
  PatchTracker tracker(std::move(first), 10, 10, context);
  test::add_patches(tracker, 40, 200);
  return tracker;
}

TEST(SlowMatchCheck, TellsHowFarFollowingFromPictureToPictureWouldDrift) {
  const test::Texture texture(5);
  const int frames = test::makes_figures() ? 200 : 40;
  PatchTracker tracker = tracker_of(on_the_way(texture, 0, 0));
  MatchCheck check(tracker);
  MatchQuality quality;
  for (int f = 1; f <= frames; ++f) {
    tracker.follow(on_the_way(texture, 2.0 * f / frames, static_cast<std::uint64_t>(f)));
    quality = check.of(tracker, 2).quality();
  }
  double squares = 0;
  for (const TrackedPatch& patch : tracker.patches()) {
    ASSERT_TRUE(patch.is_seen);
    squares += patch.motion.shift.squaredNorm() / 2;
  }
  const double off = std::sqrt(squares / tracker.count());
  std::printf(
      "after %d pictures there and back: %.4f px RMS off the start, there and back %.4f px, from "
      "picture to picture %.4f px (median), %d of %d broken\n",
      frames, off, quality.back, quality.drift, quality.broken, quality.chained);
  EXPECT_LT(off, 0.013);  // the noise of matching two pictures
  EXPECT_LT(quality.back, 0.005);
  EXPECT_GT(quality.drift, frames == 200 ? 4 * off : off);
  EXPECT_GT(quality.chained, 90);
}

TEST(MatchCheck, LosesForGoodWhatIsHiddenOnce) {
  const test::Texture texture(5);
  PatchTracker tracker = tracker_of(on_the_way(texture, 0, 0));
  MatchCheck check(tracker);
  GreyPicture hidden = on_the_way(texture, 0, 1);
  hidden.leftCols(kPixels / 2) = 0.5F;
  tracker.follow(with_noise(hidden * 255, 2));
  EXPECT_GT(check.of(tracker, 1).broken, 30);
  tracker.follow(on_the_way(texture, 0, 3));
  EXPECT_EQ(tracker.seen(), tracker.count());
  EXPECT_GT(check.of(tracker, 1).broken, 30);
}

TEST(MatchCheck, DistrustsMatchesOfABlurredPicture) {
  const test::Texture texture(5);
  PatchTracker tracker = tracker_of(on_the_way(texture, 0, 0));
  MatchCheck check(tracker);
  tracker.follow(on_the_way(texture, 0.5, 1));
  const double sharp = check.of(tracker, 1).quality().back;
  GreyPicture blurred = GreyPicture::Zero(kPixels, kPixels);
  constexpr int kExposures = 12;  // over six pixels
  for (int i = 0; i < kExposures; ++i) {
    blurred += texture.picture(kPixels, kPixels,
                               [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
                                 return place + Eigen::Vector2d(0.5 * i, 0);
                               }) /
               kExposures;
  }
  tracker.follow(with_noise(blurred, 7));
  EXPECT_GT(check.of(tracker, 1).quality().back, 3 * sharp);
}

}  // namespace
}  // namespace pliant
