#include "pliant/capture/picture_doubt.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/texture.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kPixels = 200;

/// The texture, larger by a factor, with noise of its own.
GreyPicture picture(double larger, std::uint64_t seed) {
  const test::Texture texture(5);
  GreyPicture grey =
      texture.picture(kPixels, kPixels, [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
        return Eigen::Vector2d(100, 100) + (place - Eigen::Vector2d(100, 100)) / larger;
      });
  RandomStream random(seed);
  test::add_noise(grey, 2, random);
  return grey / 255;
}

/// The means of so many pixels of a column.
GreyPicture moved_while_exposed(const GreyPicture& sharp, int pixels) {
  GreyPicture blurred = GreyPicture::Zero(sharp.rows() - pixels + 1, sharp.cols());
  for (int i = 0; i < pixels; ++i) blurred += sharp.middleRows(i, blurred.rows()) / pixels;
  GreyPicture whole = sharp;
  whole.middleRows(pixels / 2, blurred.rows()) = blurred;
  return whole;
}

PatchTracker tracker_of(GreyPicture first) {
  PatchTracker tracker(std::move(first), 10, 10, {});
  test::add_patches(tracker, 20, kPixels - 30);
  return tracker;
}

/// White is 0.6 of the brightest.
GreyPicture over_exposed(const GreyPicture& sharp) { return sharp.min(0.6F * sharp.maxCoeff()); }

class PictureDoubt : public testing::Test {
 protected:
  std::string doubt_of(const GreyPicture& now) {
    tracker_.follow(now);
    EXPECT_GT(tracker_.seen(), tracker_.count() / 2);
    return picture_doubt(tracker_, now);
  }

 private:
  PatchTracker tracker_ = tracker_of(picture(1, 1));
};

TEST_F(PictureDoubt, IsNotToldOfClothThatIsStretchedOrDarker) {
  EXPECT_THAT(doubt_of(picture(1.1, 2)), IsEmpty());
  EXPECT_THAT(doubt_of(0.5F * picture(1, 3)), IsEmpty());
}

TEST_F(PictureDoubt, IsToldOfABlurredPicture) {
  EXPECT_THAT(doubt_of(moved_while_exposed(picture(1, 2), 6)), HasSubstr("is blurred"));
}

TEST_F(PictureDoubt, IsToldOfAnOverExposedPicture) {
  EXPECT_THAT(doubt_of(over_exposed(picture(1, 2))), HasSubstr("is over-exposed"));
}

TEST(FirstPictureDoubt, IsToldOfAnOverExposedPicture) {
  EXPECT_THAT(first_picture_doubt(tracker_of(picture(1, 1))), IsEmpty());
  EXPECT_THAT(first_picture_doubt(tracker_of(over_exposed(picture(1, 1)))),
              HasSubstr("is over-exposed"));
}

TEST(FirstPictureDoubt, IsNotToldOfMuchWhitePaper) {
  GreyPicture print = over_exposed(picture(1, 1));
  RandomStream random(4);
  test::add_noise(print, 0.01, random);
  EXPECT_THAT(first_picture_doubt(tracker_of(std::move(print))), IsEmpty());
}

}  // namespace
}  // namespace pliant
