// What a sheet holds, and what is said where it does not.

#include "pliant/capture/print_layout.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/capture/pattern_drawing.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

template <typename Kind>
Pattern pattern(const Kind& kind, double width, double height) {
  Pattern result;
  result.kind = kind;
  result.sheet = {width, height};
  return result;
}

template <typename Function>
std::string refusal(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string refusal_of_sheet(const Pattern& pattern) {
  return refusal([&] { layout_of(pattern); });
}

TEST(PrintLayout, PutsABoardInTheMiddleOfItsRoom) {
  const PrintLayout layout = layout_of(pattern(TagBoard{6, 8, 0.02, 0.005, 0}, 0.21, 0.297));
  EXPECT_NEAR(layout.pattern.left + layout.pattern.right(), 0.21, 1e-12);
  EXPECT_NEAR(layout.pattern.width, 0.145, 1e-12);
  EXPECT_NEAR(layout.pattern.height, 0.195, 1e-12);
  EXPECT_LT(layout.pattern.bottom(), layout.strip.top);
  EXPECT_LT(layout.strip.bottom(), 0.297);
}

TEST(PrintLayout, SaysWhichBoardWouldFit) {
  EXPECT_EQ(refusal_of_sheet(pattern(TagBoard{10, 8, 0.02, 0.005, 0}, 0.21, 0.297)),
            "--size: a sheet of 210 mm x 297 mm has 194 mm x 264 mm for the tags, which take 250 "
            "mm x 200 mm; expected a sheet of 266 mm x 233 mm or larger, at most 7 columns and 8 "
            "rows, or tags of 15.5 mm with a gap of 3.8 mm");
  EXPECT_THAT(refusal_of_sheet(pattern(TagBoard{1, 1, 0.3, 0.05, 0}, 0.21, 0.297)),
              HasSubstr("or larger"));
}

// What is said would fit does.
TEST(PrintLayout, HoldsWhatItSaysWouldFit) {
  EXPECT_NO_THROW(layout_of(pattern(TagBoard{10, 8, 0.02, 0.005, 0}, 0.266, 0.233)));
  EXPECT_NO_THROW(layout_of(pattern(TagBoard{7, 8, 0.02, 0.005, 0}, 0.21, 0.297)));
  EXPECT_NO_THROW(layout_of(pattern(TagBoard{10, 8, 0.0155, 0.0038, 0}, 0.21, 0.297)));
  EXPECT_NO_THROW(layout_of(pattern(Chessboard{9, 6, 0.0194}, 0.21, 0.297)));
}

TEST(PrintLayout, SaysWhichSquaresLabelsAndNoiseWouldFit) {
  EXPECT_THAT(refusal_of_sheet(pattern(Chessboard{9, 6, 0.02}, 0.21, 0.297)),
              HasSubstr("for the squares, which take 200 mm x 140 mm; expected a sheet of 216 mm x "
                        "173 mm or larger, or squares of 19.4 mm"));
  ClipCodes clips{0.03, 0.03, {}};
  for (int code = 0; code < 30; ++code) clips.codes.push_back(code);
  EXPECT_THAT(refusal_of_sheet(pattern(clips, 0.21, 0.297)), HasSubstr("or at most 15 codes"));
  ClothPattern cloth;
  cloth.finest = 0.02;
  EXPECT_THAT(refusal_of_sheet(pattern(cloth, 0.21, 0.297)),
              HasSubstr("for the noise, which take 200 mm x 200 mm"));
}

TEST(PrintLayout, ChoosesTheLongestRulerThatFits) {
  EXPECT_EQ(ruler_of_sheet({0.21, 0.297}), 0.1);
  EXPECT_EQ(ruler_of_sheet({0.148, 0.21}), 0.05);
  EXPECT_EQ(ruler_of_sheet({0.09, 0.1}), 0.02);
  EXPECT_EQ(refusal([] {
              ruler_of_sheet({0.05, 0.1});
            }),
            "--size: 50 mm are too narrow for a ruler; expected a sheet 78 mm wide or wider");
}

TEST(PatternDrawing, RefusesPixelsThatAreTooManyOrTooLarge) {
  const Pattern board = pattern(TagBoard{1, 1, 0.3, 0.05, 0}, 1, 1);
  EXPECT_THAT(refusal([&] { draw_pattern(board, SheetFormat::png, 1200); }),
              HasSubstr("--dpi: 1200 on a sheet of 1 m x 1 m are too many pixels; expected at most "
                        "812"));
  ClothPattern cloth;
  cloth.dpi = 72;
  EXPECT_EQ(refusal([&] { draw_pattern(pattern(cloth, 0.21, 0.297), SheetFormat::pdf, 72); }),
            "--dpi: 72 are too few for features of 1 mm; expected at least 102");
}

}  // namespace
}  // namespace pliant
