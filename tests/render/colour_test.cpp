#include "pliant/render/colour.h"

#include <limits>

#include <gtest/gtest.h>

#include "pliant/render/colour_map.h"

namespace pliant {
namespace {

TEST(Colour, EveryPixelSurvivesDecodingAndEncoding) {
  for (int byte = 0; byte < 256; ++byte) {
    const auto value = static_cast<std::uint8_t>(byte);
    const Pixel pixel{value, 0, 255};
    EXPECT_EQ(encode_srgb(decode_srgb(pixel)), pixel);
  }
}

// IEC 61966-2-1: half of the light is encoded as 188 of 255.
TEST(Colour, HalfTheLightIsEncodedAsTheStandardSays) {
  EXPECT_EQ(encode_srgb(Colour::Constant(0.5F)), (Pixel{188, 188, 188}));
}

TEST(Colour, BeyondTheRangeIsClamped) { EXPECT_EQ(encode_srgb({-1, 2, 0}), (Pixel{0, 255, 0})); }

TEST(Colour, IsReadFromTheNotationOfTheWeb) {
  ASSERT_TRUE(parse_colour("#7fa3cf"));
  EXPECT_EQ(encode_srgb(*parse_colour("#7fa3cf")), (Pixel{0x7f, 0xa3, 0xcf}));
  for (const char* text : {"", "#", "7fa3cf", "#7fa3c", "#7fa3cg", "#7fa3cff", "#-fa3cf"}) {
    EXPECT_FALSE(parse_colour(text)) << text;
  }
}

// First and last colours of the published tables.
TEST(ColourMap, BeginsAndEndsAsPublished) {
  EXPECT_EQ(encode_srgb(map_colour(ColourMap::viridis, 0)), (Pixel{0x44, 0x01, 0x54}));
  EXPECT_EQ(encode_srgb(map_colour(ColourMap::viridis, 1)), (Pixel{0xfd, 0xe7, 0x25}));
  EXPECT_EQ(encode_srgb(map_colour(ColourMap::coolwarm, 0)), (Pixel{59, 76, 192}));
  EXPECT_EQ(encode_srgb(map_colour(ColourMap::coolwarm, 1)), (Pixel{180, 4, 38}));
}

float luminance(const Colour& colour) { return colour.dot(Colour(0.2126F, 0.7152F, 0.0722F)); }

TEST(ColourMap, ViridisGetsBrighterAllTheWay) {
  // Steps well above those of 8-bit colour.
  for (int i = 1; i <= 64; ++i) {
    EXPECT_GT(luminance(map_colour(ColourMap::viridis, i / 64.0)),
              luminance(map_colour(ColourMap::viridis, (i - 1) / 64.0)))
        << i;
  }
}

TEST(ColourMap, CoolwarmIsBrightestInTheMiddle) {
  const float middle = luminance(map_colour(ColourMap::coolwarm, 0.5));
  for (const double place : {0.0, 0.2, 0.35, 0.65, 0.8, 1.0}) {
    EXPECT_LT(luminance(map_colour(ColourMap::coolwarm, place)), middle) << place;
  }
}

TEST(ColourScale, PlacesValuesBetweenItsEnds) {
  const ColourScale scale{ColourMap::viridis, -2, 6};
  EXPECT_EQ(scale.colour(0), map_colour(ColourMap::viridis, 0.25));
  EXPECT_EQ(scale.colour(-3), map_colour(ColourMap::viridis, 0));
  EXPECT_EQ(scale.colour(1e300), map_colour(ColourMap::viridis, 1));
}

TEST(ColourScale, WithoutExtentHasItsMiddleColour) {
  const ColourScale scale{ColourMap::viridis, 1, 1};
  EXPECT_EQ(scale.colour(1), map_colour(ColourMap::viridis, 0.5));
}

TEST(ColourScale, ShowsAMissingValueInGrey) {
  const Pixel pixel = encode_srgb(ColourScale().colour(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(pixel[0], pixel[1]);
  EXPECT_EQ(pixel[1], pixel[2]);
}

}  // namespace
}  // namespace pliant
