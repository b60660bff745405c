// From a virtual lab to the report: strips whose profiles are measured.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/virtual_weights.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

/// A lab on felt ([P] 4.3), its material beside it.
class StripsFolder : public MeasuredFolder {
 public:
  StripsFolder() : MeasuredFolder(lab()) {}

 private:
  static std::string lab() {
    return "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
           "/materials/felt.json\nexperiments:\n"
           "  - {name: rolls, type: rolled-strip, direction: warp, radii: [4 mm, 7 mm, 12 mm],\n"
           "     repeats: 1, points: 15, noise: {position: 0.1 mm}}\n"
           "  - {name: overhangs, type: cantilever, direction: warp, overhangs: [50 mm, 90 mm],\n"
           "     points: 15, noise: {position: 0.1 mm}}\n";
  }
};

TEST(SlowStrips, GoFromTheLabToTheReport) {
  const StripsFolder folder;
  ASSERT_EQ(folder.made.status, 0) << folder.made.err;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json fit = json::parse(run.out);
  for (const json& e : fit["experiments"]) {
    EXPECT_EQ(e["quantity"], "distance_mm");
    EXPECT_EQ(e["component"], "bend.warp");
    EXPECT_TRUE(e["rms_percent_of_peak"].is_null());
    EXPECT_LT(e["rms_position_mm"], 0.13);  // the noise of 0.1 mm, of 28 points at least
    EXPECT_EQ(e["shape_file"], "shapes/" + e["name"].get<std::string>() + ".csv");
  }
  EXPECT_EQ(fit["experiments"][0]["unloads"], true);
  EXPECT_EQ(fit["experiments"][1]["unloads"], false);
  EXPECT_THAT(names_in(folder.path() / "fit" / "shapes"),
              IsSupersetOf({"rolls.csv", "overhangs.csv"}));
  const std::string report = content_of(folder.path() / "fit" / "report.html");
  const auto says = [&](const char* text) { return report.find(text) != std::string::npos; };
  EXPECT_TRUE(says("radius 7 mm"));
  EXPECT_TRUE(says("RMS distance 0."));
  EXPECT_FALSE(says("<figcaption>Loops"));
  EXPECT_FALSE(says("its data never unload"));
}

TEST(Strips, ArePredictedByAMaterialThatKnowsItsDensity) {
  const StripsFolder folder;
  std::string study = content_of(folder.study());
  const std::size_t begin = study.find("density:");
  study.erase(begin, study.find('\n', begin) - begin + 1);
  const std::string light = folder.write("study/light.yaml", study).string();
  const std::string felt = PLIANT_SOURCE_DIR "/materials/felt.json";
  const ProgramRun run =
      run_program({"evaluate", light, "-m", felt, "-o", folder.file("check"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = json::parse(run.out);
  for (const json& e : result["experiments"]) {
    EXPECT_LT(e["rms_position_mm"], 0.13);
  }
  const ProgramRun fit = run_program({"fit", light, "-o", folder.file("fit")});
  EXPECT_EQ(fit.status, 2);
  EXPECT_THAT(fit.last_line(), AllOf(StartsWith("error: "), HasSubstr("light.yaml:"),
                                     HasSubstr("states no density")));
}

TEST(Strips, AreToldByInfo) {
  const StripsFolder folder;
  const ProgramRun lab = run_program({"info", folder.file("lab.yaml")});
  EXPECT_THAT(lab.out, HasSubstr("4 mm, 7 mm, 12 mm; 1 repeat, 15 points a profile"));
  const ProgramRun table = run_program({"info", folder.file("study/rolls.csv")});
  EXPECT_THAT(table.out, HasSubstr("rolled-strip"));
  const ProgramRun study = run_program({"info", folder.study()});
  EXPECT_THAT(study.out, AllOf(HasSubstr("affine stiffness, friction dahl"),
                               HasSubstr("peak moment"), HasSubstr("3 profiles")));
}

}  // namespace
}  // namespace pliant::test
