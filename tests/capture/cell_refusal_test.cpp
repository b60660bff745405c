// Load cells whose cords cannot be followed are refused with what was wrong.

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/dic_file.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

/// @param cell  the keys of the only one
/// @param more  of the forces
std::string refused(const std::string& cell, const std::string& more = "",
                    const std::string& clip = "labels: [0]") {
  const TemporaryFolder folder;
  for (const char* name : {"left/0.png", "right/0.png", "other.png"}) folder.write(name, "");
  folder.write("cells.csv", "time_s,F1_N\n0,1\n1,1\n2,1\n");
  const auto file = folder.write(
      "capture.yaml",
      fmt::format("pliant: dic/1\ntest: pull\nsample: {{width: 40 mm, height: 80 mm, density: 0.1 "
                  "kg/m^2}}\n"
                  "views:\n  calibration: c.json\n  pictures: {{left: \"left/*.png\", right: "
                  "\"right/*.png\"}}\n  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]\n"
                  "clips: [{{name: a, side: bottom, {}}}]\n"
                  "forces:\n  data: cells.csv\n  cells:\n    - {{{}}}\n{}",
                  clip, cell, more));
  return test::input_error_of([&] { read_dic(file); }).what();
}

const std::string kAlong = "along: [[10, 10], [90, 10]]";
const std::string kCell = "clip: a, cord: front, column: F1, picture: left/0.png, " + kAlong;

TEST(CellRefusal, OfAClipThatIsNotThereOrHasNoLabels) {
  EXPECT_THAT(refused("clip: b, cord: front, column: F1, picture: left/0.png, " + kAlong),
              HasSubstr("\"b\" is no clip"));
  EXPECT_THAT(refused(kCell, "", "motion: held"), HasSubstr("without `labels`"));
}

TEST(CellRefusal, OfOnePixelOrTwoThatTellNoDirection) {
  EXPECT_THAT(
      refused("clip: a, cord: front, column: F1, picture: left/0.png, along: [[10, 10], [12, 10]]"),
      HasSubstr("too near each other"));
  EXPECT_THAT(refused("clip: a, cord: front, column: F1, picture: left/0.png, along: [[10, 10]]"),
              HasSubstr("are not two places"));
}

TEST(CellRefusal, OfACordTwiceOrOfASlopeBelowZero) {
  EXPECT_THAT(refused(kCell + "}\n    - {" + kCell), HasSubstr("another cell reads"));
  EXPECT_THAT(
      refused(kCell + "}\n    - {clip: a, cord: front, column: F2, picture: left/0.png, " + kAlong),
      HasSubstr("stands here twice"));
  EXPECT_THAT(refused(kCell + ", slope: -1"), HasSubstr("is no slope of a cell"));
}

TEST(CellRefusal, OfATimeWithoutRate) {
  EXPECT_THAT(refused(kCell, "  still: 1 s\n"), HasSubstr("needs the `rate`"));
}

TEST(CellRefusal, OfATesterBesideCells) {
  EXPECT_THAT(refused(kCell, "  on: a\n"), HasSubstr("stands beside `cells`"));
}

}  // namespace
}  // namespace pliant
