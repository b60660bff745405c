// `pliant fit --resume`: a fit of sessions that was stopped goes on.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"

#include "app/virtual_weights.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kLab =
    "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
    "/examples/assumed-cloth.json\nexperiments:\n"
    "  - {name: pull, type: session, test: stretch-weft, frames: 10, mesh: {nodes: 13x13}}\n"
    "  - {name: table, type: session, test: bend-weft, frames: 10, mesh: {nodes: 13x13}}\n";

json fit_in(const std::filesystem::path& results) {
  return json::parse(read_text_file(results / "fit.json"));
}

TEST(SlowFitResume, GoesOnAfterCtrlC) {
  const MeasuredFolder folder(kLab);
  const std::filesystem::path results = folder.path() / "out";
  const std::vector<std::string> fit{"fit", folder.study(), "-o", results.string()};
  const ProgramRun stopped = run_program(fit, {.interrupt_after = kSanitizerFactor});
  EXPECT_EQ(stopped.status, 1) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("--resume goes on from"));
  EXPECT_TRUE(std::filesystem::exists(results / "progress.bin"));
  EXPECT_FALSE(std::filesystem::exists(results / "fit.json"));
  const ProgramRun info = run_program({"info", (results / "progress.bin").string(), "--json"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_GT(json::parse(info.out)["answers"], 0);

  std::vector<std::string> resume = fit;
  resume.push_back("--resume");
  const ProgramRun resumed = run_program(resume);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(std::filesystem::exists(results / "progress.bin"));
  ASSERT_EQ(run_program({"fit", folder.study(), "-o", folder.file("whole")}).status, 0);
  const json whole = fit_in(folder.path() / "whole")["parameters"];
  const json found = fit_in(results)["parameters"];
  ASSERT_EQ(found.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const double expected = whole[i]["value"];
    EXPECT_NEAR(found[i]["value"].get<double>(), expected, 0.01 * expected) << whole[i]["name"];
  }
}

TEST(FitResume, NeedsProgress) {
  const MeasuredFolder folder;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--resume"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("no progress of a fit")));
}

}  // namespace
}  // namespace pliant::test
