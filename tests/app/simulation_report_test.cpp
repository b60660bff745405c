// `pliant report` and `pliant info` on results of a simulation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/imaging/picture_file.h"
#include "pliant/io/base64.h"

#include "app/run_program.h"
#include "support/simulation_folder.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

bool can_draw() { return run_program({"--help"}).out.find("\n  render ") != std::string::npos; }

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class SimulationReportCommand : public ::testing::Test {
 protected:
  ProgramRun report() const { return run_program({"report", folder.file("sim")}); }
  std::string html() const { return content_of(folder.file("sim/report.html")); }

  const SimulationFolder folder{8};
};
using SlowSimulationReportCommand = SimulationReportCommand;

TEST_F(SlowSimulationReportCommand, WritesOneFileWithPicturesOfTheFrames) {
  const ProgramRun run = report();
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(html(), StartsWith("<!DOCTYPE html>"));
  // Six frames side by side, and the field of the last one.
  EXPECT_EQ(count(html(), "<img class=\"picture\""), can_draw() ? 2 : 0);
  EXPECT_EQ(count(html(), "src=\"data:image/png;base64,iVBORw0KGgo"), can_draw() ? 2 : 0);
  EXPECT_EQ(count(html(), "No pictures: this program was built without"), can_draw() ? 0 : 1);
}

// Pixels of the first picture that are as warm a grey as obstacles are.
int warm_greys(const std::string& html) {
  const std::string before = "src=\"data:image/png;base64,";
  const size_t begin = html.find(before) + before.size();
  const auto bytes = bytes_of_base64(html.substr(begin, html.find('"', begin) - begin));
  const TemporaryFolder folder;
  const ColourPhoto picture = read_picture(folder.write("picture.png", bytes.value()));
  int found = 0;
  for (size_t i = 0; i < picture.levels.size(); i += 3) {
    const int blue = picture.levels[i], red = picture.levels[i + 2];
    found += red > blue && red - blue <= 12 ? 1 : 0;
  }
  return found;
}

TEST_F(SlowSimulationReportCommand, ShowsObstacles) {
  if (!can_draw()) GTEST_SKIP() << "this program was built without pictures";
  ASSERT_EQ(report().status, 0);
  const int without = warm_greys(html());
  folder.write("sim/obstacles.obj", "v 1 1 0\nv 2 1 0\nv 2 1 1\nv 1 1 1\nf 1 2 3 4\n");
  folder.write_summary(R"({"index": 0, "time": 0}, {"index": 1, "time": 0.04})",
                       R"(, "obstacles": "obstacles.obj")");
  ASSERT_EQ(report().status, 0);
  EXPECT_GT(warm_greys(html()), without + 1000);
}

TEST_F(SimulationReportCommand, SaysSoWhereTheFramesAreNoPlyFiles) {
  if (!can_draw()) GTEST_SKIP() << "this program was built without pictures";
  std::filesystem::remove_all(folder.file("sim/frames"));
  EXPECT_EQ(report().status, 0);
  EXPECT_THAT(html(), AllOf(HasSubstr("the frames were not written as PLY files"),
                            Not(HasSubstr("<img class"))));
}

TEST_F(SlowSimulationReportCommand, SaysInJsonWhatItWrote) {
  const ProgramRun run = run_program({"report", folder.file("sim"), "--json"});
  EXPECT_EQ(nlohmann::json::parse(run.out)["command"], "report");
}

TEST_F(SimulationReportCommand, LeavesNoReportOnDamagedResults) {
  folder.write("sim/simulation.json", "{\"pliant\": \"simulation/1\", \"frames\": [");
  const ProgramRun run = report();
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("simulation.json")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("sim/report.html")));
}

TEST_F(SimulationReportCommand, NamesTheFrameThatCannotBeRead) {
  if (!can_draw()) GTEST_SKIP() << "this program was built without pictures";
  folder.write("sim/frames/000007.ply", "ply\nformat ascii 1.0\n");
  const ProgramRun run = report();
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("000007.ply"));
}

TEST(InfoCommand, DescribesTheResultsOfASimulation) {
  const SimulationFolder folder(8);
  for (const char* name : {"sim", "sim/simulation.json"}) {
    const ProgramRun run = run_program({"info", folder.file(name), "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const nlohmann::json json = nlohmann::json::parse(run.out);
    EXPECT_THAT(json["type"].get<std::string>(), StartsWith("simulation/1"));
    EXPECT_EQ(json["triangles"], 2);
    EXPECT_EQ(json["frames"], 8);
  }
  std::filesystem::rename(folder.file("sim/simulation.json"), folder.file("sim/other.json"));
  const ProgramRun run = run_program({"info", folder.file("sim/other.json")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("under another name"));
}

}  // namespace
}  // namespace pliant::test
