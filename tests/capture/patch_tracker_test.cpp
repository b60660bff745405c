#include "pliant/capture/patch_tracker.h"

#include <gtest/gtest.h>

#include "capture/texture.h"

namespace pliant {
namespace {

constexpr int kPixels = 200;
const Eigen::Vector2d kBy(8, 0);

using Brightness = std::function<double(const Eigen::Vector2d&)>;

GreyPicture picture(const Brightness& at, const Eigen::Vector2d& by, std::uint64_t seed) {
  GreyPicture picture(kPixels, kPixels);
  for (int row = 0; row < kPixels; ++row) {
    for (int column = 0; column < kPixels; ++column) {
      picture(row, column) = static_cast<float>(at(Eigen::Vector2d(column, row) - by));
    }
  }
  RandomStream random(seed);
  test::add_noise(picture, 2, random);
  return picture;
}

/// Looks along rows for what has moved by eight pixels.
PatchTracker found_across(const Brightness& at) {
  PatchTracker tracker(picture(at, {0, 0}, 1), 10, 10, {});
  for (int y = 20; y <= 170; y += 10) {
    for (int x = 20; x <= 170; x += 10) tracker.add({x, y});
  }
  tracker.find_across(picture(at, kBy, 2), [](const Eigen::Vector2d&) {
    std::vector<PatchMotion> candidates;
    for (int x = -80; x <= 80; x += 4) candidates.push_back({.shift = {x, 0}});
    return candidates;
  });
  return tracker;
}

TEST(PatchTracker, FindsAnIrregularTextureAlongCandidates) {
  const test::Texture texture(5);
  const PatchTracker tracker =
      found_across([&](const Eigen::Vector2d& place) { return texture.at(place); });
  EXPECT_EQ(tracker.seen(), tracker.count());
  for (const TrackedPatch& patch : tracker.patches()) {
    EXPECT_LT((patch.motion.shift - kBy).norm(), 0.1);
  }
}

// A weave is the same again every 28 pixels of a row.
TEST(PatchTracker, GuessesNoPlaceOfAWeaveAlongCandidates) {
  const PatchTracker tracker =
      found_across([](const Eigen::Vector2d& place) { return test::weave_at(place, 14); });
  EXPECT_EQ(tracker.seen(), 0);
}

}  // namespace
}  // namespace pliant
