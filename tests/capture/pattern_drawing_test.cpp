// Prints are of the size that they say, whatever turns them to pixels: their tags are found, and
// are as long as they should be.

#include "pliant/capture/pattern_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/print_layout.h"
#include "pliant/capture/tag_detector.h"

#include "capture/printed_sheet.h"

namespace pliant::test {
namespace {

using ::testing::HasSubstr;

template <typename Kind>
Pattern pattern(const Kind& kind, double width, double height) {
  Pattern result;
  result.kind = kind;
  result.sheet = {width, height};
  result.ruler = ruler_of_sheet(result.sheet);
  return result;
}

/// A sheet of the size of a hand.
Pattern small_board() { return pattern(TagBoard{3, 3, 0.015, 0.004, 580 - 9}, 0.08, 0.1); }
Pattern full_board() { return pattern(TagBoard{}, 0.21, 0.297); }
Pattern eight_clips() {
  return pattern(ClipCodes{0.015, 0.015, {0, 1, 2, 3, 4, 5, 6, 586}}, 0.21, 0.297);
}

double millimetres(double pixels, int dpi) { return pixels * 25.4 / dpi; }

std::map<int, DetectedTag> tags_of(const GreyPicture& picture) {
  const TagsByCode tags = tags_by_code(detect_tags(picture));
  EXPECT_THAT(tags.twice, testing::IsEmpty());
  return tags.once;
}

/// The largest difference of a side from what it should be, as a share of that.
double largest_error_of_sides(const std::map<int, DetectedTag>& tags, double tag, int dpi) {
  double largest = 0;
  for (const auto& [code, found] : tags) {
    for (int i = 0; i < 4; ++i) {
      const double side = (found.corners.col((i + 1) % 4) - found.corners.col(i)).norm();
      largest = std::max(largest, std::abs(millimetres(side, dpi) / (1e3 * tag) - 1));
    }
  }
  return largest;
}

void expect_size(const GreyPicture& picture, const Eigen::Vector2d& size, int dpi) {
  const Eigen::Vector2i pixels = pixels_of_sheet(size, dpi);
  EXPECT_EQ(picture.cols(), pixels.x());
  EXPECT_EQ(picture.rows(), pixels.y());
}

/// All tags are where the board says, up to a shift.
void expect_board(const GreyPicture& picture, const Pattern& printed, int dpi) {
  constexpr double kSides = 0.002;  // of a side, as the project asks
  constexpr double kPlaces = 0.05;  // mm, half a pixel at 300 dpi
  expect_size(picture, printed.sheet, dpi);
  const auto& board = std::get<TagBoard>(printed.kind);
  const auto tags = tags_of(picture);
  ASSERT_EQ(static_cast<int>(tags.size()), board.tag_count());
  const double error = largest_error_of_sides(tags, board.tag, dpi);
  std::printf("at %d dpi sides are off by %.3f %% at most\n", dpi, 100 * error);
  EXPECT_LT(error, kSides) << dpi << " dpi";
  const SheetBox box = layout_of(printed).pattern;
  for (const auto& [code, found] : tags) {
    ASSERT_TRUE(board.has(code)) << code;
    const auto corners = board.corners(code);
    for (int i = 0; i < 4; ++i) {  // pixel 0 begins at the sheet's edge
      const Eigen::Vector2d place(box.left + corners[i].x(), box.bottom() - corners[i].y());
      const Eigen::Vector2d seen = (found.corners.col(i).array() + 0.5) * 25.4 / dpi;
      EXPECT_LT((seen - 1e3 * place).norm(), kPlaces) << code << " corner " << i;
    }
  }
}

TEST(PatternDrawing, HasTagsOfTheRightSizeInPng) {
  for (const int dpi : {300, 600}) {
    expect_board(read_png(draw_pattern(small_board(), SheetFormat::png, dpi)), small_board(), dpi);
  }
}

TEST(SlowPatternDrawing, HasTagsOfTheRightSizeInPdf) {
  if (!can_turn_pdf_to_pixels()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  const std::string pdf = draw_pattern(small_board(), SheetFormat::pdf, 600);
  for (const int dpi : {300, 600}) expect_board(pixels_of_pdf(pdf, dpi), small_board(), dpi);
}

TEST(SlowPatternDrawing, HasTagsOfTheRightSizeOnA4) {
  if (!can_turn_pdf_to_pixels()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  constexpr int kDpi = 300;  // small boards are looked at with 600, too
  const std::string pdf = draw_pattern(full_board(), SheetFormat::pdf, 600);
  expect_board(pixels_of_pdf(pdf, kDpi), full_board(), kDpi);
  expect_board(read_png(draw_pattern(full_board(), SheetFormat::png, kDpi)), full_board(), kDpi);
}

TEST(SlowPatternDrawing, HasLabelsOfTheRightSize) {
  if (!can_turn_pdf_to_pixels()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  const Pattern printed = eight_clips();
  const auto& clips = std::get<ClipCodes>(printed.kind);
  const std::string pdf = draw_pattern(printed, SheetFormat::pdf, 600);
  const GreyPicture picture = pixels_of_pdf(pdf, 300);
  const auto tags = tags_of(picture);
  ASSERT_EQ(tags.size(), clips.codes.size());
  for (const int code : clips.codes) EXPECT_TRUE(tags.contains(code)) << code;
  EXPECT_LT(largest_error_of_sides(tags, clips.tag, 300), 0.002);
  // The line of the clip's edge, seen from beside the tag, where no text is.
  const GreyPicture turned = picture.transpose();
  const Eigen::Vector2d middle = tags.at(3).middle();
  const auto beside = static_cast<Eigen::Index>(middle.x() + 16 * 300 / 25.4);
  const auto below = static_cast<Eigen::Index>(middle.y() + 9 * 300 / 25.4);
  const auto runs = dark_runs(turned, beside, below, below + 118);  // 10 mm
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(millimetres(runs[0].middle() - middle.y(), 300), 15, 0.05);
}

TEST(PatternDrawing, HasSquaresOfTheRightSize) {
  const Pattern printed = pattern(Chessboard{4, 3, 0.011}, 0.08, 0.1);
  constexpr int kDpi = 300;
  const GreyPicture picture = read_png(draw_pattern(printed, SheetFormat::png, kDpi));
  const SheetBox box = layout_of(printed).pattern;
  const auto pixel = [](double metres) {
    return static_cast<Eigen::Index>(metres / 0.0254 * kDpi);
  };
  const auto first = dark_runs(picture, pixel(box.top + 0.005), 0, picture.cols());
  const auto second = dark_runs(picture, pixel(box.top + 0.016), 0, picture.cols());
  ASSERT_EQ(first.size(), 3u);  // of five squares: the first is black
  ASSERT_EQ(second.size(), 2u);
  EXPECT_NEAR(millimetres(first[0].length(), kDpi), 11, 0.02);
  EXPECT_NEAR(millimetres(second[0].begin - first[0].begin, kDpi), 11, 0.02);
  EXPECT_NEAR(millimetres(first[2].end - first[0].begin, kDpi), 55, 0.02);
}

TEST(SlowPatternDrawing, HasARulerOfMillimetres) {
  constexpr int kDpi = 600;
  for (const double width : {0.21, 0.148}) {
    const Pattern printed = pattern(Chessboard{4, 3, 0.011}, width, 0.1);
    const GreyPicture picture = read_png(draw_pattern(printed, SheetFormat::png, kDpi));
    const SheetBox strip = layout_of(printed).strip;
    const auto row = static_cast<Eigen::Index>((strip.top + 5e-3) / 0.0254 * kDpi);
    const auto end = static_cast<Eigen::Index>((strip.left + printed.ruler + 3e-3) / 0.0254 * kDpi);
    const auto ticks = dark_runs(picture, row, 0, end);
    ASSERT_EQ(ticks.size(), 1e3 * printed.ruler + 1) << width;
    const double length = ticks.back().middle() - ticks.front().middle();
    EXPECT_NEAR(millimetres(length, kDpi), 1e3 * printed.ruler, 0.01) << width;
  }
}

TEST(PatternDrawing, HasAnArrowAlongTheWeftOnClothAlone) {
  constexpr int kDpi = 300;
  const auto shaft = [](const Pattern& printed, GreyPicture& picture) {
    picture = read_png(draw_pattern(printed, SheetFormat::png, kDpi));
    const SheetBox strip = layout_of(printed).strip;
    const auto row = static_cast<Eigen::Index>((strip.top + 3e-3) / 0.0254 * kDpi);
    const auto from = static_cast<Eigen::Index>((strip.left + 0.106) / 0.0254 * kDpi);
    return dark_runs(picture, row, from, picture.cols());
  };
  ClothPattern cloth;
  cloth.dpi = kDpi;
  GreyPicture picture;
  EXPECT_TRUE(shaft(pattern(Chessboard{4, 3, 0.011}, 0.21, 0.1), picture).empty());
  const auto runs = shaft(pattern(cloth, 0.21, 0.1), picture);
  ASSERT_GE(runs.size(), 5u);  // the arrow, and four letters
  EXPECT_NEAR(millimetres(runs[0].length(), kDpi), 18, 0.2);
  // It is wide near its right end.
  const GreyPicture turned = picture.transpose();
  const auto width_at = [&](double x) {
    return dark_runs(turned, static_cast<Eigen::Index>(x), picture.rows() - 260, picture.rows())
        .front()
        .length();
  };
  EXPECT_GT(width_at(runs[0].end - 35), 4 * width_at(runs[0].begin + 35));
}

TEST(PatternDrawing, ShowsTheNoisePixelByPixel) {
  ClothPattern cloth;
  cloth.dpi = 150;
  const Pattern printed = pattern(cloth, 0.1, 0.08);
  const GreyPicture picture = read_png(draw_pattern(printed, SheetFormat::png, 600));
  expect_size(picture, printed.sheet, 150);  // its own
  const SheetBox box = layout_of(printed).pattern;
  const double pixel = 0.0254 / cloth.dpi;
  const auto left = static_cast<Eigen::Index>(std::ceil(box.left / pixel));
  const auto columns = static_cast<Eigen::Index>(std::floor(box.right() / pixel)) - left;
  const Eigen::Index rows = columns / 2;
  const GreyPicture noise = 255 * picture.block(left, left, rows, columns);
  EXPECT_NEAR(std::sqrt((noise - noise.mean()).square().mean()), 51, 5);
  EXPECT_EQ(picture(left - 1, left - 1), 1);
}

TEST(PatternDrawing, TellsItsSizeInEveryFormat) {
  const std::string svg = draw_pattern(small_board(), SheetFormat::svg, 600);
  EXPECT_THAT(svg, HasSubstr("width=\"80mm\" height=\"100mm\" viewBox=\"0 0 80 100\""));
  const std::string pdf = draw_pattern(small_board(), SheetFormat::pdf, 600);
  EXPECT_THAT(pdf, HasSubstr("226.7716"));  // 80 mm in points
  EXPECT_THAT(pdf, HasSubstr("283.4645"));
  const std::string png = draw_pattern(small_board(), SheetFormat::png, 600);
  const std::size_t chunk = png.find("pHYs");
  ASSERT_NE(chunk, std::string::npos);
  // 600 dpi are 23622 pixels a metre, in x and in y.
  EXPECT_EQ(png.substr(chunk + 4, 9), std::string("\0\0\x5c\x46\0\0\x5c\x46\1", 9));
}

TEST(PatternDrawing, GivesTheSameBytesAgain) {
  ClothPattern cloth;
  cloth.dpi = 150;
  // An SVG numbers its parts through the life of a program; tests/app compares those of two.
  for (const SheetFormat format : {SheetFormat::pdf, SheetFormat::png}) {
    for (const Pattern& printed : {small_board(), pattern(cloth, 0.1, 0.08)}) {
      EXPECT_TRUE(draw_pattern(printed, format, 150) == draw_pattern(printed, format, 150));
    }
  }
  EXPECT_EQ(draw_pattern(small_board(), SheetFormat::pdf, 300).find("CreationDate"),
            std::string::npos);
}

TEST(PatternDrawing, EmbedsNoiseAsGreyLevels) {
  ClothPattern cloth;
  cloth.dpi = 300;
  const Pattern printed = pattern(cloth, 0.1, 0.08);
  EXPECT_THAT(draw_pattern(printed, SheetFormat::svg, 300),
              HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  if (!can_turn_pdf_to_pixels()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  const GreyPicture png = read_png(draw_pattern(printed, SheetFormat::png, 300));
  const GreyPicture pdf = pixels_of_pdf(draw_pattern(printed, SheetFormat::pdf, 300), 300);
  ASSERT_EQ(png.rows(), pdf.rows());
  ASSERT_EQ(png.cols(), pdf.cols());
  // The same noise: a page drawn at the noise's own resolution may be off by a part of a pixel,
  // a twelfth of its finest waves.
  const Eigen::Index skip = 110, size = 400;
  const GreyPicture difference = (png - pdf).block(skip, skip, size, size);
  EXPECT_LT(std::sqrt(difference.square().mean()), 0.05);
}

}  // namespace
}  // namespace pliant::test
