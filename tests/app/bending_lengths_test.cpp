// From a virtual lab to the report: strips pushed over an edge.

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

/// A lab on felt ([P] 4.3), its material beside it.
class LengthsFolder : public MeasuredFolder {
 public:
  LengthsFolder()
      : MeasuredFolder("pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
                       "/materials/felt.json\nexperiments:\n"
                       "  - {name: lengths, type: bending-length, direction: warp, repeats: 4,\n"
                       "     noise: {overhang: 0.5 mm}, resolution: {overhang: 0.5 mm}}\n") {}
};

TEST(BendingLengths, GoFromTheLabToTheReport) {
  const LengthsFolder folder;
  ASSERT_EQ(folder.made.status, 0) << folder.made.err;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json fit = json::parse(run.out);
  ASSERT_EQ(fit["parameters"].size(), 1u);
  EXPECT_EQ(fit["parameters"][0]["name"], "bend.warp.k");
  EXPECT_EQ(fit["experiments"][0]["quantity"], "overhang_mm");
  EXPECT_EQ(fit["experiments"][0]["unloads"], false);
  EXPECT_LT(fit["experiments"][0]["rms_position_mm"], 1);  // twice the noise
  EXPECT_TRUE(fit["experiments"][0]["rms_force_N"].is_null());
  const std::string report = content_of(folder.path() / "fit" / "report.html");
  const auto says = [&](const char* text) { return report.find(text) != std::string::npos; };
  EXPECT_TRUE(says("of mean overhang"));
  EXPECT_TRUE(says("<figcaption>Readings"));
  EXPECT_FALSE(says("<figcaption>Loops"));
  EXPECT_TRUE(says("coefficient of variation"));
}

// The fabric's own bending length is what `info` gives of its material.
TEST(SlowBendingLengths, AreToldByInfo) {
  const LengthsFolder folder;
  const ProgramRun material =
      run_program({"info", PLIANT_SOURCE_DIR "/materials/felt.json", "--json"});
  const json textile = json::parse(material.out)["components"]["bend.warp"]["textile"];
  const ProgramRun table = run_program({"info", folder.file("study/lengths.csv"), "--json"});
  const json read = json::parse(table.out);
  EXPECT_EQ(read["usable_as"], json::array({"bending-length"}));
  ASSERT_EQ(read["bending_length"]["faces"].size(), 3u);
  const json& both = read["bending_length"]["faces"][2];
  EXPECT_EQ(both["readings"], 8);
  EXPECT_NEAR(both["bending_length_m"].get<double>(), textile["bending_length_m"].get<double>(),
              5e-4);  // noise 0.5 mm of eight overhangs, halved
  EXPECT_TRUE(both["flexural_rigidity_N_m"].is_null());
  const json study =
      json::parse(run_program({"info", folder.study(), "--json"}).out)["experiments"][0];
  const json& weighed = study["bending_length"]["faces"][2];
  EXPECT_NEAR(weighed["flexural_rigidity_N_m"].get<double>() /
                  textile["flexural_rigidity_N_m"].get<double>(),
              1, 0.05);
  const ProgramRun lab = run_program({"info", folder.file("lab.yaml")});
  EXPECT_THAT(lab.out,
              AllOf(HasSubstr("4 of each face, at 41.5 deg"), HasSubstr("overhang 500 um")));
  const ProgramRun text = run_program({"info", folder.study()});
  EXPECT_THAT(text.out, AllOf(HasSubstr("constant stiffness"), HasSubstr("both faces, 8 readings"),
                              HasSubstr("flexural rigidity")));
}

}  // namespace
}  // namespace pliant::test
