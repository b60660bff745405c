// Bad input: status 2, one line that says where and what, and nothing written.

#include <algorithm>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/run_program.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kStudy[] =
    "pliant: study/1\n"
    "name: test\n"
    "density: 0.15 kg/m^2\n"
    "experiments:\n"
    "  - name: weights\n"
    "    type: hanging-weights\n"
    "    direction: warp\n"
    "    data: weights.csv\n"
    "    length: 100 mm\n"
    "    width: 100 mm\n"
    "    clip_mass: 20 g\n";

constexpr char kWeights[] =
    "repeat,peak_N,step,weight_N,length_mm\n"
    "1,2,0,0,100.5\n"
    "1,2,1,1,110\n"
    "1,2,2,2,120\n"
    "1,2,3,1,113\n"
    "1,2,4,0,102\n"
    "2,2,0,0,102\n"
    "2,2,1,1,111\n"
    "2,2,2,2,121\n";

/// The part of a text that a case replaces; all of it where `from` is empty.
struct Edit {
  std::string from, to;
};

struct BadInput {
  std::string name;
  Edit study, weights;
  std::string where;  ///< file and line, e.g. "study.yaml:3"; an empty one is not asked for
  std::string field;
  std::vector<std::string> says = {};  ///< words of the message

  friend void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.name; }
};

std::string edited(std::string text, const Edit& edit) {
  if (edit.from.empty()) return edit.to.empty() ? text : edit.to;
  const size_t at = text.find(edit.from);
  EXPECT_NE(at, std::string::npos) << edit.from;
  return text.replace(at, edit.from.size(), edit.to);
}

/// What every refusal has in common.
void expect_refusal(const ProgramRun& run, const std::filesystem::path& output) {
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, StartsWith("error: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_FALSE(std::filesystem::exists(output)) << "a folder was made";
}

class RefusedStudy : public ::testing::TestWithParam<BadInput> {};

TEST_P(RefusedStudy, NamesFileLineAndFieldAndLeavesNothing) {
  const BadInput& bad = GetParam();
  const TemporaryFolder folder;
  const std::string study = folder.write("study.yaml", edited(kStudy, bad.study)).string();
  folder.write("weights.csv", bad.weights.to == "(empty)" ? "" : edited(kWeights, bad.weights));
  const auto output = folder.path() / "deep" / "fit";
  const ProgramRun run = run_program({"fit", study, "-o", output.string()});
  expect_refusal(run, folder.path() / "deep");
  if (!bad.where.empty()) {
    EXPECT_THAT(run.err,
                StartsWith(fmt::format("error: {}/{}: ", folder.path().string(), bad.where)));
  }
  EXPECT_THAT(run.err, HasSubstr(bad.field));
  for (const std::string& words : bad.says) EXPECT_THAT(run.err, HasSubstr(words));
}

const BadInput kBadStudies[] = {
    {"UnknownKey", {"clip_mass:", "clipmass:"}, {}, "study.yaml:11", "clipmass", {"clip_mass"}},
    {"KeyGivenTwice", {"name: test\n", "name: test\nname: again\n"}, {}, "study.yaml:3", "name"},
    {"UnknownVersion", {"study/1", "study/9"}, {}, "study.yaml:1", "pliant", {"study/1"}},
    {"UnknownDocument", {"study/1", "scene/1"}, {}, "study.yaml:1", "pliant", {"study/1"}},
    {"UnknownUnit", {"100 mm", "100 furlong"}, {}, "study.yaml:9", "length", {"furlong", "mm"}},
    {"WrongKindOfUnit", {"20 g", "20 mm"}, {}, "study.yaml:11", "clip_mass", {"g"}},
    {"NumberWithoutUnit", {"100 mm", "100"}, {}, "study.yaml:9", "length", {"mm"}},
    {"NegativeLengthInStudy", {"100 mm", "-100 mm"}, {}, "study.yaml:9", "length"},
    {"UnknownExperimentType",
     {"hanging-weights", "hanging-weight"},
     {},
     "study.yaml:6",
     "type",
     {"hanging-weights"}},
    {"MissingField", {"    direction: warp\n", ""}, {}, "study.yaml:5", "direction"},
    {"MisspeltField",
     {"direction:", "directon:"},
     {},
     "study.yaml:5",
     "direction",
     {"is missing (did you mean it by `directon`?)"}},
    {"MisspeltExperiments",
     {"experiments:", "experimets:"},
     {},
     "study.yaml:1",
     "experiments",
     {"`experimets`"}},
    {"MissingDataFile",
     {"weights.csv", "other.csv"},
     {},
     "study.yaml:8",
     "experiments[0].data",
     {"other.csv", "does not exist"}},
    {"DirectoryAsData", {"weights.csv", "."}, {}, "", "", {"directory"}},
    {"NoExperiments",
     {"", "pliant: study/1\nname: test\nexperiments: []\n"},
     {},
     "study.yaml:3",
     "experiments"},
    {"BrokenYaml", {"direction: warp", "direction: [warp"}, {}, "", "study.yaml"},
    {"ExcludedRowsBeyondTheData",
     {"clip_mass: 20 g\n", "clip_mass: 20 g\n    exclude: [{rows: 9-20, reason: slip}]\n"},
     {},
     "study.yaml:5",
     "exclude",
     {"9-20"}},
    {"PatternWithoutMatch", {"weights.csv", "weft-*.csv"}, {}, "study.yaml:8", "data"},
    {"ValidateMatchesNothing",
     {"clip_mass: 20 g\n", "clip_mass: 20 g\nvalidate: [\"*-2cm\"]\n"},
     {},
     "study.yaml:12",
     "validate",
     {"*-2cm"}},
    {"MissingColumn", {}, {"length_mm", "strain"}, "weights.csv:1", "length"},
    {"RepeatedColumn", {}, {"peak_N", "weight_N"}, "weights.csv:1", "weight_N"},
    {"UnknownUnitInHeader", {}, {"length_mm", "length_furlong"}, "weights.csv:1", "length"},
    {"TextForANumber", {}, {"110", "long"}, "weights.csv:3", "length_mm", {"long"}},
    {"NaN", {}, {"110", "NaN"}, "weights.csv:3", "length_mm", {"NaN"}},
    {"Inf", {}, {"110", "inf"}, "weights.csv:3", "length_mm", {"inf"}},
    {"EmptyCell", {}, {"110", ""}, "weights.csv:3", "length_mm"},
    {"RaggedRow", {}, {"1,2,1,1,110", "1,2,1,1"}, "weights.csv:3", ""},
    {"EmptyFile", {}, {"", "(empty)"}, "weights.csv", ""},
    {"HeaderAlone", {}, {"", "repeat,peak_N,step,weight_N,length_mm\n"}, "weights.csv:1", ""},
    {"OneRow", {}, {"", "weight_N,length_mm\n0,100\n"}, "weights.csv:2", "", {"row"}},
    {"DecreasingStep", {}, {"1,2,2,2,120", "1,2,0,2,120"}, "weights.csv:4", "step"},
    {"NegativeLength", {}, {"110", "-110"}, "weights.csv:3", "length"},
    {"ConstantForce",
     {},
     {"", "weight_N,length_mm\n1,100\n1,101\n1,102\n1,103\n"},
     "weights.csv:2",
     "weight"},
};

INSTANTIATE_TEST_SUITE_P(Table, RefusedStudy, ::testing::ValuesIn(kBadStudies),
                         [](const auto& bad) { return bad.param.name; });

ProgramRun refuse_file(const TemporaryFolder& folder, const std::string& file) {
  const auto output = folder.path() / "fit";
  const ProgramRun run = run_program({"fit", file, "-o", output.string()});
  expect_refusal(run, output);
  return run;
}

TEST(RefusedFile, DirectoryInPlaceOfAStudy) {
  const TemporaryFolder folder;
  EXPECT_THAT(refuse_file(folder, folder.path().string()).err, HasSubstr("directory"));
}

TEST(RefusedFile, ThatDoesNotExist) {
  const TemporaryFolder folder;
  EXPECT_THAT(refuse_file(folder, (folder.path() / "none.yaml").string()).err,
              HasSubstr("none.yaml"));
}

TEST(RefusedFile, U3mWithoutMeasurements) {
  const TemporaryFolder folder;
  const auto file = folder.write("fabric.json", R"({"schema": "1.1", "custom": null})"
                                                "\n");
  EXPECT_THAT(refuse_file(folder, file.string()).err, HasSubstr("fabric.json"));
}

TEST(RefusedFile, TruncatedJson) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "fabric.json", "{\"schema\": \"1.1\",\n \"raw_data\": {\"M\": 150, \"L\": {\"S2\": {\"len");
  EXPECT_THAT(refuse_file(folder, file.string()).err, HasSubstr("fabric.json:2"));
}

TEST(RefusedFile, JsonNestedAHundredThousandDeep) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("fabric.json", std::string(100000, '[') + std::string(100000, ']'));
  EXPECT_THAT(refuse_file(folder, file.string()).err, HasSubstr("fabric.json:1"));
}

TEST(RefusedFile, YamlNestedAHundredThousandDeep) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.yaml", std::string(100000, '['));
  EXPECT_THAT(refuse_file(folder, file.string()).err, HasSubstr("study.yaml:1"));
}

TEST(RefusedFile, YamlAliasBomb) {
  const TemporaryFolder folder;
  std::string text = "a0: &a0 [lol, lol, lol, lol, lol, lol, lol, lol, lol, lol]\n";
  for (int i = 1; i < 10; ++i) {
    text += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i,
                        i - 1);
  }
  const ProgramRun run = refuse_file(folder, folder.write("study.yaml", text).string());
  EXPECT_LT(run.peak_memory_kb, kSanitizerFactor * 200 * 1024);  // the limit for a fit
}

// A sparse file: 1 GB long, hardly a block on the disk. The data is refused without being held in
// memory.
TEST(RefusedFile, OneLineOfAGigabyte) {
  const TemporaryFolder folder;
  folder.write("weights.csv", kWeights);
  std::filesystem::resize_file(folder.path() / "weights.csv", std::uintmax_t{1} << 30);
  const ProgramRun run = refuse_file(folder, folder.write("study.yaml", kStudy).string());
  EXPECT_THAT(run.err, HasSubstr("weights.csv"));
  EXPECT_LT(run.peak_memory_kb, kSanitizerFactor * 200 * 1024);
}

TEST(RefusedFile, MaterialWithoutTheComponentOfTheStudy) {
  const TemporaryFolder folder;
  const auto study = folder.write("study.yaml", edited(kStudy, {"warp", "weft"}));
  folder.write("weights.csv", kWeights);
  const auto output = folder.path() / "check";
  const ProgramRun run =
      run_program({"evaluate", study.string(), "-m", PLIANT_SOURCE_DIR "/materials/cotton.json",
                   "-o", output.string()});
  expect_refusal(run, output);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stretch.weft"), HasSubstr("cotton")));
}

TEST(RefusedFile, LabWithAnUnknownKey) {
  const TemporaryFolder folder;
  const auto lab = folder.write("lab.yaml", "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
                                            "/materials/cotton.json\nspeciments: 3\n");
  const auto output = folder.path() / "made";
  const ProgramRun run = run_program({"lab", lab.string(), "-o", output.string()});
  expect_refusal(run, output);
}

}  // namespace
}  // namespace pliant::test
