#include "pliant/capture/match_noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/tag_drawing.h"
#include "capture/texture.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kPixels = 200;

/// Of two pictures of a texture that differ by noise, 2 grey levels of 255, through a lens that
/// blurs.
std::string doubt_of_lens(double blur) {
  const auto same = [](const Eigen::Vector2d& place) { return place; };
  const GreyPicture sharp = test::Texture(5).picture(kPixels, kPixels, same);
  const auto taken = [&](std::uint64_t seed) -> GreyPicture {
    GreyPicture picture = blur > 0 ? test::blurred(sharp, blur) : sharp;
    RandomStream random(seed);
    test::add_noise(picture, 2, random);
    return picture / 255;
  };
  PatchTracker tracker(taken(1), 10, 10, {});
  test::add_patches(tracker, 20, kPixels - 30);
  tracker.follow(taken(2));
  MatchNoise noise;
  noise.add(tracker);
  return noise.doubt();
}

TEST(MatchNoise, IsSmallInFocus) { EXPECT_THAT(doubt_of_lens(0), IsEmpty()); }

TEST(MatchNoise, IsToldWhereAllPicturesAreBlurredAlike) {
  EXPECT_THAT(doubt_of_lens(4), HasSubstr("it is blurred or noisy"));
}

}  // namespace
}  // namespace pliant
