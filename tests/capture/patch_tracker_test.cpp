#include "pliant/capture/patch_tracker.h"

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "capture/texture.h"

namespace pliant {
namespace {

constexpr int kPixels = 200;
const Eigen::Vector2d kBy(8, 0);

using Brightness = std::function<double(const Eigen::Vector2d&)>;

GreyPicture picture(const Brightness& at, const Eigen::Vector2d& by, std::uint64_t seed) {
  GreyPicture picture =
      test::drawn(kPixels, kPixels, [&](const Eigen::Vector2d& place) { return at(place - by); });
  RandomStream random(seed);
  test::add_noise(picture, 2, random);
  return picture;
}

PatchTracker tracker_of(const Brightness& at, const RunContext& context) {
  PatchTracker tracker(picture(at, {0, 0}, 1), 10, 10, context);
  test::add_patches(tracker, 20, 170);
  return tracker;
}

std::vector<PatchMotion> along_rows(const Eigen::Vector2d& /*place*/) {
  std::vector<PatchMotion> candidates;
  for (int x = -80; x <= 80; x += 4) candidates.push_back({.shift = {x, 0}});
  return candidates;
}

/// Looks along rows for what has moved by eight pixels.
PatchTracker found_across(const Brightness& at) {
  PatchTracker tracker = tracker_of(at, {});
  tracker.find_across(picture(at, kBy, 2), along_rows);
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

RunContext remembering(Journal& journal) { return {silent_progress(), {}, 1, 0, journal}; }

void expect_same(const PatchTracker& found, const PatchTracker& expected) {
  for (int i = 0; i < expected.count(); ++i) {
    const TrackedPatch& one = found.patches()[static_cast<std::size_t>(i)];
    const TrackedPatch& other = expected.patches()[static_cast<std::size_t>(i)];
    EXPECT_TRUE(one.motion.shift == other.motion.shift && one.motion.slope == other.motion.slope);
    EXPECT_TRUE(one.covariance == other.covariance && one.correlation == other.correlation);
    EXPECT_TRUE(one.is_seen == other.is_seen && one.by_core == other.by_core);
  }
}

// Part of the texture leaves the picture, so that not all is found.
TEST(PatchTracker, RecallsWhatItsJournalKnowsAndGoesOnFromThere) {
  const test::Texture texture(5);
  const Brightness at = [&](const Eigen::Vector2d& place) { return texture.at(place); };
  const std::vector<GreyPicture> pictures{picture(at, kBy, 2), picture(at, {25, 3}, 3),
                                          picture(at, {30, 5}, 4)};
  Journal first([](const auto&) {}), second([](const auto&) {});
  PatchTracker whole = tracker_of(at, remembering(first));
  whole.find_across(pictures[0], along_rows);
  whole.follow(pictures[1]);
  EXPECT_LT(whole.seen(), whole.count());

  second.resume(first.content(), "progress.bin");
  PatchTracker recalled = tracker_of(at, remembering(second));
  recalled.find_across(pictures[0], along_rows);
  recalled.follow(pictures[1]);
  EXPECT_EQ(second.content().entries.size(), 2u);  // nothing new was asked
  expect_same(recalled, whole);
  whole.follow(pictures[2]);
  recalled.follow(pictures[2]);
  EXPECT_EQ(second.content().entries.size(), 3u);
  expect_same(recalled, whole);
}

TEST(PatchTracker, RecallsNothingThatWasSearchedElsewhere) {
  const test::Texture texture(5);
  const Brightness at = [&](const Eigen::Vector2d& place) { return texture.at(place); };
  Journal first([](const auto&) {}), second([](const auto&) {});
  tracker_of(at, remembering(first)).find_across(picture(at, kBy, 2), along_rows);
  second.resume(first.content(), "progress.bin");
  PatchTracker other = tracker_of(at, remembering(second));
  EXPECT_THROW(other.find_across(picture(at, kBy, 2),
                                 [](const Eigen::Vector2d&) {
                                   return std::vector<PatchMotion>{{.shift = {8, 0}}};
                                 }),
               InputError);
}

}  // namespace
}  // namespace pliant
