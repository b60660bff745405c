#include "pliant/capture/frame_moments.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::filesystem::path> pictures(const std::vector<int>& numbers) {
  std::vector<std::filesystem::path> files;
  for (const int number : numbers) files.emplace_back(fmt::format("left/a2-{:06}.png", number));
  return files;
}

TEST(FrameMoments, AreCountedByTheNumbersInNames) {
  EXPECT_THAT(moments_by_names(pictures({1, 2, 4})), ElementsAre(0, 1, 3));
  EXPECT_THAT(moments_by_names(pictures({1, 2, 3})), ElementsAre(0, 1, 2));
  EXPECT_THAT(gap_doubt(pictures({1, 2, 4})),
              HasSubstr("left/a2-000004.png comes after a2-000002.png: by the numbers in their "
                        "names 1 of the frames are missing"));
  EXPECT_THAT(gap_doubt(pictures({1, 2, 3})), IsEmpty());
}

// One in ten of a film was kept.
TEST(FrameMoments, AreCountedByTheSmallestStep) {
  EXPECT_THAT(moments_by_names(pictures({100, 110, 130})), ElementsAre(0, 1, 3));
  EXPECT_THAT(moments_by_names(pictures({100, 110, 125})), ElementsAre(0, 1, 2));
}

// A picture a second, and one in twenty seconds, from minute to minute.
TEST(FrameMoments, AreNotCountedByTimesOfDay) {
  std::vector<int> seconds;
  for (int second = 50; second < 170; ++second) {
    seconds.push_back(120000 + 100 * (second / 60) + second % 60);
  }
  EXPECT_EQ(moments_by_names(pictures(seconds)).back(), 119);
  EXPECT_THAT(moments_by_names(pictures({120000, 120020, 120040, 120100})),
              ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(gap_doubt(pictures(seconds)),
              HasSubstr("of 120 pictures lack 80: they are no count of frames"));
}

TEST(FrameMoments, TellWhichPictureIsOfAnotherMoment) {
  EXPECT_EQ(other_moment(pictures({1, 3, 4}), pictures({1, 2, 4})), 1);
  EXPECT_EQ(other_moment(pictures({1, 2, 4}), pictures({11, 12, 14})), std::nullopt);
}

TEST(FrameMoments, AreOneAfterTheOtherWhereNamesTellNone) {
  EXPECT_THAT(moments_by_names({"rest.png", "pulled.png"}), ElementsAre(0, 1));
  EXPECT_THAT(moments_by_names({"a1.png", "a2.png", "b4.png"}), ElementsAre(0, 1, 2));
  EXPECT_THAT(moments_by_names({"1.png", "10.png", "2.png"}), ElementsAre(0, 1, 2));
  EXPECT_THAT(moments_by_names({"7.png"}), ElementsAre(0));
}

}  // namespace
}  // namespace pliant
