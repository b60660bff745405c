// Tags that stand still tell that a camera does not, on pictures that are drawn.
#include "pliant/capture/fixed_tags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "capture/tag_drawing.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

/// The tag 7 of 56 pixels, larger by a share and shifted (pixels).
GreyPicture picture_of_tag(double larger = 0, const Eigen::Vector2d& shift = {0, 0}) {
  Eigen::Matrix<double, 2, 4> corners;
  corners << 32, 88, 88, 32,  //
      88, 88, 32, 32;
  corners = ((1 + larger) * corners).colwise() + shift;
  return test::draw_tag(128, 128, 7, corners, 0.7);
}

TagsByCode tags_in(const GreyPicture& picture) { return tags_by_code(detect_tags(picture)); }

FixedTags fixed_tags(const std::vector<int>& codes, const GreyPicture& first) {
  return {codes, first, tags_in(first), "p/0.png"};
}

const FixedTags& fixed_tag() {
  static const FixedTags tags = fixed_tags({7, 8}, picture_of_tag());
  return tags;
}

TEST(FixedTags, SayNothingOfACameraThatStandsStill) {
  EXPECT_EQ(fixed_tag().doubt(tags_in(picture_of_tag())), "");
  EXPECT_EQ(fixed_tag().doubt(tags_in(0.7f * picture_of_tag())), "") << "in another light";
}

TEST(FixedTags, TellACameraThatWasMoved) {
  EXPECT_THAT(fixed_tag().doubt(tags_in(picture_of_tag(0, {0.6, 0.8}))),
              HasSubstr("shows the fixed tag 7 1.0 pixels off where it was at first"));
}

// From the corner of the picture, which is told by what is farthest away from it.
TEST(FixedTags, TellACameraThatWasRefocused) {
  EXPECT_THAT(fixed_tag().doubt(tags_in(picture_of_tag(0.0096))),
              HasSubstr("shows the fixed tag 7 1.2 pixels off"));
}

TEST(FixedTags, TellAPictureThatShowsNone) {
  EXPECT_THAT(fixed_tag().doubt(tags_in(GreyPicture::Constant(128, 128, 0.5f))),
              HasSubstr("shows none of the fixed tags"));
}

TEST(FixedTags, AreRefusedWhereTheFirstPictureShowsNone) {
  const InputError error = test::input_error_of([] { fixed_tags({8, 9}, picture_of_tag()); });
  EXPECT_THAT(error.what(), HasSubstr("p/0.png: shows none of the fixed tags 8, 9"));
}

TEST(FixedTags, AreRefusedWhereACodeIsSeenTwice) {
  GreyPicture twice(128, 256);
  twice << picture_of_tag(), picture_of_tag();
  const InputError error = test::input_error_of([&] { fixed_tags({7}, twice); });
  EXPECT_THAT(error.what(), HasSubstr("shows the fixed tag 7 more than once"));
}

}  // namespace
}  // namespace pliant
