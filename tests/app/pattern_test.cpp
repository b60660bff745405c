// `pliant pattern`: a drawing and the document beside it, and what is refused.

#include "pliant/capture/pattern.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ProgramRun run_pattern(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "pattern");
  ProgramOptions options;
  options.working_directory = folder.path();
  return run_program(arguments, options);
}

/// The line that refuses a command, of which nothing may stay.
std::string refusal(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  const ProgramRun run = run_pattern(folder, std::move(arguments));
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(names_in(folder.path()).empty());
  return run.last_line();
}

TEST(PatternCommand, WritesADrawingAndWhatItShows) {
  const TemporaryFolder folder;
  const ProgramRun run = run_pattern(
      folder, {"board", "-o", "small.pdf", "--columns", "4", "--rows", "3", "--tag", "12 mm",
               "--gap", "3 mm", "--first-code", "100", "--size", "100 mm x 100 mm", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("small.pdf: board on 100 mm x 100 mm, ruler 20 mm; print it at "
                                 "100 %"));
  const json summary = json::parse(run.out);
  EXPECT_EQ(summary["document"], "small.yaml");
  EXPECT_EQ(summary["sheet"], json({0.1, 0.1}));
  EXPECT_THAT(content_of(folder.path() / "small.pdf"), StartsWith("%PDF"));
  const Pattern pattern = read_pattern(folder.path() / "small.yaml");
  const auto& board = std::get<TagBoard>(pattern.kind);
  EXPECT_EQ(board.columns, 4);
  EXPECT_EQ(board.rows, 3);
  EXPECT_EQ(board.first_code, 100);
  EXPECT_DOUBLE_EQ(board.tag, 0.012);
  EXPECT_DOUBLE_EQ(board.gap, 0.003);
  EXPECT_EQ(pattern.ruler, 0.02);

  const ProgramRun info = run_program({"info", (folder.path() / "small.yaml").string(), "--json"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_EQ(json::parse(info.out)["type"], "pattern/1");
  EXPECT_EQ(json::parse(info.out)["kind"], "board");
}

TEST(PatternCommand, DrawsEveryKindOnA4) {
  const TemporaryFolder folder;
  for (const char* kind : {"board", "chessboard", "clips"}) {
    const std::string file = std::string(kind) + ".svg";
    ASSERT_EQ(run_pattern(folder, {kind, "-o", file}).status, 0) << kind;
    EXPECT_THAT(content_of(folder.path() / file), HasSubstr("</svg>"));
    const Pattern pattern = read_pattern(folder.path() / (std::string(kind) + ".yaml"));
    EXPECT_EQ(kind_name(pattern), kind);
    // Ten squares are wider than the sheet, but not than the sheet turned.
    EXPECT_EQ(pattern.sheet.x(), std::string(kind) == "chessboard" ? 0.297 : 0.21) << kind;
    EXPECT_EQ(pattern.ruler, 0.1);
  }
}

TEST(PatternCommand, DrawsTheSameNoiseForTheSameSeed) {
  const TemporaryFolder folder;
  const auto draw = [&](const std::string& file, const char* seed) {
    const ProgramRun run = run_pattern(folder, {"cloth", "-o", file, "--seed", seed, "--dpi", "150",
                                                "--size", "100 mm x 80 mm", "--camera", "0.5 mm"});
    EXPECT_EQ(run.status, 0) << run.err;
    return content_of(folder.path() / file);
  };
  for (const char* ending : {".pdf", ".svg", ".png"}) {
    const std::string first = draw(std::string("a") + ending, "7");
    EXPECT_TRUE(first == draw(std::string("b") + ending, "7")) << ending;
    EXPECT_FALSE(first == draw(std::string("c") + ending, "8")) << ending;
  }
  const auto cloth = std::get<ClothPattern>(read_pattern(folder.path() / "a.yaml").kind);
  EXPECT_EQ(cloth.seed, 7u);
  EXPECT_DOUBLE_EQ(cloth.camera, 0.5e-3);
  EXPECT_DOUBLE_EQ(cloth.finest, 2e-3);
  EXPECT_EQ(cloth.dpi, 150);
}

TEST(PatternCommand, ReadsListsOfCodes) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_pattern(folder, {"clips", "-o", "c.pdf", "--codes", "5, 1-3,586"}).status, 0);
  const Pattern pattern = read_pattern(folder.path() / "c.yaml");
  EXPECT_THAT(std::get<ClipCodes>(pattern.kind).codes, ElementsAre(5, 1, 2, 3, 586));
}

TEST(PatternCommand, RefusesCodesThatThereAreNot) {
  for (const char* codes : {"", ",", "a", "3-1", "-1", "580-587", "1,1", "1-"}) {
    const std::string line = refusal({"clips", "-o", "c.pdf", std::string("--codes=") + codes});
    EXPECT_THAT(line, StartsWith("error: --codes")) << codes;
  }
  EXPECT_EQ(
      refusal({"clips", "-o", "c.pdf", "--codes", "1-3,2"}),
      "error: --codes: 2 is there twice; expected codes from 0 to 586, e.g. 1-8 or 0,3,10-12");
}

TEST(PatternCommand, RefusesWhatCannotBeDrawn) {
  EXPECT_EQ(refusal({"board", "-o", "board.jpg"}),
            "error: board.jpg: is no name of a drawing; expected a name that ends in .pdf, .svg or "
            ".png");
  EXPECT_EQ(refusal({"chessboard", "-o", "c.pdf", "--tag", "20 mm"}),
            "error: --tag: is no option of `chessboard`; expected --columns, --rows, --square of "
            "`chessboard`");
  EXPECT_THAT(refusal({"chessboard", "-o", "c.pdf", "--columns", "8"}),
              HasSubstr("--columns: 8 x 6 inner corners look the same upside down"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--columns", "12"}),
              HasSubstr("--size: a sheet of 210 mm x 297 mm has"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--size", "A4"}),
              HasSubstr("--size: \"A4\" is no size; expected WIDTH x HEIGHT"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--size", "210 x 297"}),
              HasSubstr("--size: \"210\" has no unit"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--tag", "0 mm"}), HasSubstr("is not positive"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--gap", "1 mm"}),
              HasSubstr("--gap: 1 mm are less than the white that tags of 20 mm need; expected "
                        "2.5 mm or more"));
  EXPECT_THAT(refusal({"board", "-o", "b.pdf", "--first-code", "550"}),
              HasSubstr("--first-code: 48 tags from code 550 need codes up to 597"));
  EXPECT_THAT(refusal({"clips", "-o", "c.pdf", "--edge", "8 mm"}),
              HasSubstr("--edge: 8 mm from a tag's middle leave no white below it"));
  EXPECT_THAT(refusal({"cloth", "-o", "c.pdf", "--dpi", "50"}),
              HasSubstr("--dpi: 50 are too few for features of 1 mm; expected at least 102"));
  EXPECT_THAT(refusal({"rug", "-o", "c.pdf"}), HasSubstr("rug"));
}

TEST(PatternCommand, WritesOverNoDocumentThatIsSomebodysWork) {
  const TemporaryFolder folder;
  const auto study = folder.write("cloth.yaml", "pliant: study/1\nname: cloth\n");
  const ProgramRun run = run_pattern(folder, {"board", "-o", "cloth.pdf"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("cloth.yaml: is there already, and no pattern"));
  EXPECT_THAT(content_of(study), HasSubstr("study/1"));

  ASSERT_EQ(run_pattern(folder, {"board", "-o", "b.pdf"}).status, 0);
  ASSERT_EQ(run_pattern(folder, {"board", "-o", "b.pdf", "--tag", "15 mm"}).status, 0);
  folder.write("b.yaml",
               "pliant: pattern/1\nchessboard: {columns: 9, rows: 6, square: 2 cm}\n"
               "ruler: {drawn: 100 mm, measured: 99 mm}\n");
  const ProgramRun measured = run_pattern(folder, {"board", "-o", "b.pdf"});
  EXPECT_EQ(measured.status, 2);
  EXPECT_THAT(measured.last_line(), HasSubstr("b.yaml: tells of a print whose ruler was measured"));
}

}  // namespace
}  // namespace pliant::test
