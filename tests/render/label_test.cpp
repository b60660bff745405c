// Text and what is drawn with it.

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/geometry/stroke_font.h"
#include "pliant/render/annotations.h"

#include "render/small_scenes.h"

namespace pliant {
namespace {

using test::brightness;
using test::is_background;

std::string all_characters() {
  std::string text;
  for (char c = ' '; c <= '~'; ++c) text += c;
  return text;
}

/// What is drawn on an image, in pixels; empty for a blank one.
Eigen::AlignedBox2i drawn_box(const Image& image) {
  Eigen::AlignedBox2i box;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!is_background(image.at(x, y))) box.extend(Eigen::Vector2i(x, y));
    }
  }
  return box;
}

TEST(StrokeFont, DrawsEveryAsciiCharacterInsideItsLine) {
  for (const char c : all_characters()) {
    const std::string text(1, c);
    const std::vector<Segment> segments = text_segments(text, 10);
    EXPECT_EQ(segments.empty(), c == ' ') << c;
    for (const Segment& segment : segments) {
      for (const Eigen::Vector2f& point : {segment.from, segment.to}) {
        EXPECT_GE(point.x(), -0.3F) << c;
        EXPECT_LE(point.x(), text_width(text, 10) + 0.3F) << c;
        EXPECT_GE(point.y(), -3.01F) << c;
        EXPECT_LE(point.y(), 11.5F) << c;
      }
    }
  }
}

TEST(StrokeFont, DrawsNoTwoCharactersAlike) {
  const auto lines_of = [](char c) {
    std::vector<float> numbers;
    for (const Segment& s : text_segments(std::string(1, c), 10)) {
      numbers.insert(numbers.end(), {s.from.x(), s.from.y(), s.to.x(), s.to.y()});
    }
    return numbers;
  };
  const std::string characters = all_characters();
  for (size_t i = 0; i < characters.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_NE(lines_of(characters[i]), lines_of(characters[j])) << characters[i] << characters[j];
    }
  }
}

TEST(StrokeFont, HasDigitsOfOneWidth) {
  for (char c = '0'; c <= '9'; ++c) {
    EXPECT_EQ(text_width(std::string(1, c), 10), text_width("0", 10)) << c;
  }
}

TEST(StrokeFont, DrawsACharacterOutsideAsciiAsOneBox) {
  EXPECT_EQ(text_segments("\xc2\xb5", 10).size(), 4u);
  EXPECT_EQ(text_width("\xe2\x82\xac", 10), text_width("\xc2\xb5", 10));
}

TEST(StrokeFont, ScalesWithItsHeight) {
  EXPECT_FLOAT_EQ(text_width("t = 0.25 s", 30), 3 * text_width("t = 0.25 s", 10));
}

TEST(Text, IsAlignedToItsBasePoint) {
  const std::string text = "HHH";
  const float width = text_width(text, 12);
  for (const auto& [alignment, left] : {std::pair(TextAlignment::left, 100.0F),
                                        {TextAlignment::centre, 100 - width / 2},
                                        {TextAlignment::right, 100 - width}}) {
    Image image(200, 40);
    draw_text(image, text, {100, 30}, alignment, {12, {0, 0, 0}});
    // Half a stroke (0.8) and half a pixel of smoothing beyond its lines, in whole pixels.
    EXPECT_NEAR(drawn_box(image).min().x(), left, 2);
    EXPECT_NEAR(drawn_box(image).max().x(), left + width, 2);
    EXPECT_NEAR(drawn_box(image).max().y(), 30, 2);
    EXPECT_NEAR(drawn_box(image).min().y(), 18, 2);
  }
}

TEST(Text, IsReadableOnADarkPicture) {
  Image image(100, 40, {0, 0, 0});
  draw_text(image, "I", {50, 30}, TextAlignment::left, {12, {0, 0, 0}});
  EXPECT_GT(brightness(image.at(52, 24)), 400);  // the rim beside the stroke
  EXPECT_LT(brightness(image.at(49, 24)) + brightness(image.at(50, 24)), 600);
}

TEST(Text, MayReachOutOfThePicture) {
  Image image(20, 10);
  draw_text(image, "far too long for it", {-30, 5});
  draw_text(image, "elsewhere", {300, 500});
  draw_text(image, "", {5, 5});
}

FieldLegend legend() { return {"friction_stress", "N/m", {ColourMap::viridis, 0, 2}}; }

TEST(ColourBar, ShowsTheMapFromBottomToTopInItsStrip) {
  Image image(400, 300);
  const TextStyle style = label_style(300);
  draw_colour_bar(image, legend(), style);
  const Eigen::AlignedBox2i box = drawn_box(image);
  const int strip = colour_bar_width(legend(), style);
  EXPECT_GE(box.min().x(), 400 - strip - 1);  // half a stroke of the name
  EXPECT_LT(box.max().x(), 400);
  // The bar takes 11/20 of the height, rows 67 to 231, its frame one pixel.
  const int column = 400 - strip + 5;
  for (const int row : {1, 40, 82, 120, 163}) {
    const double place = 1 - (row + 0.5) / 165;
    EXPECT_EQ(image.at(column, 67 + row), encode_srgb(map_colour(ColourMap::viridis, place)));
  }
}

TEST(ColourBar, IsWiderForALongerName) {
  FieldLegend longer = legend();
  longer.name += "_of_something_else";
  const TextStyle style = label_style(300);
  EXPECT_GT(colour_bar_width(longer, style), colour_bar_width(legend(), style));
}

TEST(ColourBar, SaysBelowItselfThatItEndsAtPercentiles) {
  FieldLegend cut = legend();
  cut.percentiles = true;
  const TextStyle style = label_style(300);
  Image plain(400, 300), noted(400, 300);
  draw_colour_bar(plain, legend(), style);
  draw_colour_bar(noted, cut, style);
  // The bar ends at row 231.
  EXPECT_LT(drawn_box(plain).max().y(), 240);
  EXPECT_GT(drawn_box(noted).max().y(), 250);
  EXPECT_LT(drawn_box(noted).max().y(), 290);
  EXPECT_LT(drawn_box(noted).max().x(), 400);
}

TEST(ColourBar, OfOneValueIsDrawn) {
  Image image(400, 300);
  draw_colour_bar(image, {"strain", "1", {ColourMap::viridis, 0.1, 0.1}}, label_style(300));
  EXPECT_FALSE(drawn_box(image).isEmpty());
}

TEST(TimeLabel, StandsInTheUpperLeftCorner) {
  Image image(400, 300);
  draw_time(image, 0.25, 2);
  const Eigen::AlignedBox2i box = drawn_box(image);
  EXPECT_LT(box.max().x(), 100);
  EXPECT_LT(box.max().y(), 30);
}

}  // namespace
}  // namespace pliant
