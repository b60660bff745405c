// What a pattern/1 document says, and where the corners are that it tells of.

#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/capture/pattern.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

constexpr double kRounding = 1e-12;  // m

Pattern parsed(const std::string& text) {
  return pattern_of(parse_yaml("pliant: pattern/1\n" + text, "p.yaml"));
}

std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(PatternFile, GivesBackWhatWasWritten) {
  Pattern board, chessboard, clips, cloth;
  board.kind = TagBoard{5, 7, 0.0213, 0.0054, 100};
  board.sheet = {0.2, 0.28};
  board.ruler = 0.05;
  chessboard.kind = Chessboard{8, 5, 0.0254};
  clips.kind = ClipCodes{0.012, 0.01, {3, 1}};
  cloth.kind = ClothPattern{18'446'744'073'709'551'615U, 0.2e-3, 0.8e-3, 3, 300};
  for (const Pattern& pattern : {board, chessboard, clips, cloth}) {
    const Pattern read = pattern_of(parse_yaml(pattern_text(pattern), "p.yaml"));
    EXPECT_EQ(pattern_text(read), pattern_text(pattern));
    EXPECT_EQ(kind_name(read), kind_name(pattern));
    EXPECT_EQ(read.file, "p.yaml");
    EXPECT_FALSE(read.measured_ruler.has_value());
  }
  EXPECT_THAT(pattern_text(board), HasSubstr("tag: 21.3 mm, gap: 5.4 mm, first_code: 100"));
}

TEST(PatternFile, ScalesLengthsByTheRulerThatWasMeasured) {
  const Pattern pattern = parsed(
      "board: {columns: 2, rows: 3, tag: 20 mm, gap: 5 mm}\n"
      "ruler: {drawn: 100 mm, measured: 99 mm}\n");
  const auto& board = std::get<TagBoard>(pattern.kind);
  EXPECT_NEAR(board.tag, 0.0198, kRounding);
  EXPECT_NEAR(board.gap, 0.00495, kRounding);
}

TEST(TagBoard, CountsCodesAsOneReadsAndCornersAsLibapriltagDoes) {
  const TagBoard board{3, 2, 0.02, 0.005, 10};
  EXPECT_TRUE(board.has(15));
  EXPECT_FALSE(board.has(16) || board.has(9));
  const auto upper_left = board.corners(10), lower_right = board.corners(15);
  EXPECT_TRUE(upper_left[0].isApprox(Eigen::Vector3d(0, 0.025, 0)));
  EXPECT_TRUE(upper_left[1].isApprox(Eigen::Vector3d(0.02, 0.025, 0)));
  EXPECT_TRUE(upper_left[2].isApprox(Eigen::Vector3d(0.02, 0.045, 0)));
  EXPECT_TRUE(upper_left[3].isApprox(Eigen::Vector3d(0, 0.045, 0)));
  EXPECT_TRUE(lower_right[0].isApprox(Eigen::Vector3d(0.05, 0, 0)));
  EXPECT_TRUE(board.extent().isApprox(Eigen::Vector2d(0.07, 0.045)));
}

TEST(Chessboard, CountsInnerCornersFromTheUpperLeftOne) {
  const Chessboard board{9, 6, 0.02};
  EXPECT_EQ(board.corner_count(), 54);
  EXPECT_TRUE(board.shows_up());
  EXPECT_TRUE(board.corner(0).isApprox(Eigen::Vector3d(0, 0.1, 0)));
  EXPECT_TRUE(board.corner(10).isApprox(Eigen::Vector3d(0.02, 0.08, 0)));
  EXPECT_TRUE(board.corner(53).isApprox(Eigen::Vector3d(0.16, 0, 0)));
  EXPECT_TRUE(board.extent().isApprox(Eigen::Vector2d(0.2, 0.14)));
}

TEST(PatternFile, RefusesWhatNoSheetCanShow) {
  EXPECT_EQ(refusal("board: {columns: 60, rows: 10, tag: 20 mm, gap: 5 mm}"),
            "p.yaml:2: board.rows: asks for codes up to 599; expected codes up to 586, the last of "
            "tag36h11");
  EXPECT_EQ(refusal("clips: {tag: 15 mm, edge: 15 mm, codes: [3, 3]}"),
            "p.yaml:2: clips.codes[1]: 3 stands here twice; expected a code for each");
  EXPECT_THAT(refusal("clips: {tag: 15 mm, edge: 7 mm, codes: [3]}"),
              HasSubstr("clips.edge: is within the tag; expected 7.5 mm or more"));
  EXPECT_THAT(refusal("sheet: {width: 1 m, height: 1 m}"),
              HasSubstr("says nothing that was drawn; expected `board`, `chessboard`"));
  EXPECT_THAT(refusal("chessboard: {columns: 9, rows: 6, square: 2 cm}\n"
                      "ruler: {drawn: 100 mm, measured: 10 mm}"),
              HasSubstr("ruler.measured: is not near what was drawn"));
  EXPECT_THAT(refusal("clips: {tag: 15 mm, edge: 15 mm, codes: [3]}\n"
                      "cloth: {camera: 1 mm, finest: 4 mm, octaves: 1, dpi: 72}"),
              HasSubstr("cloth: stands beside `clips`; expected one of them"));
}

}  // namespace
}  // namespace pliant
