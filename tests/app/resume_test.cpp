// Simulations that are stopped or killed go on to the same bits.

#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Scheme {
  const char* name;
  const char* time;  // of a scene; long enough to be ended half-way
};

void PrintTo(const Scheme& scheme, std::ostream* out) { *out << scheme.name; }

const Scheme kSchemes[] = {
    {"Bdf2", "{step: 2 ms, duration: 400 ms, integrator: bdf2}"},
    {"LinearizedBackwardEuler",
     "{step: 1 ms, duration: 400 ms, solve: linearized, friction: linearized}"},
    {"QuasiStatic", "{kind: quasi-static, steps: 40, duration: 400 ms}"}};

// Without PLY files the report has no pictures, which take longer than the simulation.
constexpr const char* kOutput = "{every: 20 ms, formats: [vtu, pc2], fields: [strain, friction]}";

/// Waits until a run has written a file, at most as long as the whole run may take.
bool appears(const std::filesystem::path& file) {
  for (int i = 0; i < 3000; ++i) {
    if (std::filesystem::exists(file)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

json summary_in(const std::filesystem::path& results) {
  return json::parse(content_of(results / "simulation.json"));
}

class SlowResume : public ::testing::TestWithParam<Scheme> {
 protected:
  void SetUp() override {
    folder.write("scene.yaml", small_scene(GetParam().time, kOutput));
    ASSERT_EQ(folder.simulate({}, "whole").status, 0);
  }

  /// Starts a run with checkpoints and ends it with a signal after its first one.
  ProgramRun end_with(int signal) const {
    StartedProgram program(folder.command({"--checkpoint-every", "40 ms"}), {});
    EXPECT_TRUE(appears(folder.results() / "checkpoint.bin"));
    kill(program.pid(), signal);
    return program.wait();
  }

  void expect_the_whole() const {
    expect_same_files(folder.computed_files("whole"), folder.computed_files());
    const json whole = summary_in(folder.results("whole")), found = summary_in(folder.results());
    EXPECT_EQ(found["finished"], true);
    for (const char* key :
         {"steps", "frames", "fields", "substeps", "newton_iterations", "linear_iterations"}) {
      EXPECT_EQ(found[key], whole[key]) << key;
    }
  }

  SceneFolder folder;
};

TEST_P(SlowResume, AfterBeingKilledEndsInTheSameBits) {
  EXPECT_EQ(end_with(SIGKILL).status, -SIGKILL);
  const json stopped = summary_in(folder.results());
  EXPECT_EQ(stopped["finished"], false);
  // Any number of threads gives these bits.
  const ProgramRun run =
      folder.simulate({"--resume", "--checkpoint-every", "100 ms", "--threads", "3"});
  ASSERT_EQ(run.status, 0) << run.err;
  expect_the_whole();
}

TEST_P(SlowResume, AfterCtrlCEndsInTheSameBits) {
  const ProgramRun stopped = end_with(SIGINT);
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("--resume goes on from"));
  EXPECT_THAT(stopped.last_line(), AllOf(StartsWith("error: "), HasSubstr("interrupted")));
  const json told = summary_in(folder.results());
  EXPECT_EQ(told["finished"], false);
  EXPECT_GT(told["steps"], 0);
  const ProgramRun run = folder.simulate({"--resume"});
  ASSERT_EQ(run.status, 0) << run.err;
  expect_the_whole();
}

INSTANTIATE_TEST_SUITE_P(Schemes, SlowResume, ::testing::ValuesIn(kSchemes),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

class Resume : public ::testing::Test {
 protected:
  Resume() {
    folder.write("scene.yaml", small_scene("{step: 10 ms, duration: 100 ms}", kOutput));
    run = folder.simulate({"--checkpoint-every", "30 ms", "--threads", "1"});
    before = folder.computed_files();
  }

  ProgramRun resume(const std::vector<std::string>& arguments = {"--threads", "1"}) const {
    std::vector<std::string> all{"--resume"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return folder.simulate(all);
  }

  void expect_refused(const ProgramRun& refused, const std::string& words) const {
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.last_line(), AllOf(StartsWith("error: "), HasSubstr(words)));
    // What was there has not been touched.
    EXPECT_EQ(folder.computed_files(), before);
  }

  SceneFolder folder;
  ProgramRun run;
  std::map<std::string, std::string> before;  // what it computed
};
using SlowResumed = Resume;

TEST_F(Resume, GoesOnFromTheLastCheckpointOfAFinishedRun) {
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(resume().status, 0);
  expect_same_files(before, folder.computed_files());
}

TEST_F(SlowResumed, GoesOnForLongerWhereTheDurationIsRaised) {
  const auto scene = [](const std::string& duration) {
    // Frames every 20 ms: that at 50 ms stands at the end of the shorter run alone.
    return small_scene("{step: 10 ms, duration: " + duration + "}", kOutput);
  };
  folder.write("scene.yaml", scene("120 ms"));
  ASSERT_EQ(folder.simulate({"--threads", "1"}, "whole").status, 0);
  const std::map<std::string, std::string> whole = folder.computed_files("whole");
  folder.write("scene.yaml", scene("50 ms"));
  ASSERT_EQ(folder.simulate({"--threads", "1"}, "longer").status, 0);
  folder.write("longer/notes.txt", "the end looks good");
  folder.write("scene.yaml", scene("120 ms"));
  const ProgramRun longer = folder.simulate({"--resume", "--threads", "1"}, "longer");
  ASSERT_EQ(longer.status, 0) << longer.err;
  std::map<std::string, std::string> found = folder.computed_files("longer");
  EXPECT_EQ(found.erase("notes.txt"), 1U);
  expect_same_files(whole, found);
}

TEST_F(Resume, RefusesADurationThatIsSimulatedAlready) {
  folder.write("scene.yaml", small_scene("{step: 10 ms, duration: 50 ms}", kOutput));
  expect_refused(resume(), "are simulated already");
}

TEST_F(Resume, NeedsACheckpoint) {
  std::filesystem::remove(folder.results() / "checkpoint.bin");
  expect_refused(resume(), "holds no checkpoint");
}

TEST_F(Resume, LeavesNoFolderWhereThereWasNone) {
  EXPECT_EQ(folder.simulate({"--resume"}, "none").status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.results("none")));
}

TEST_F(Resume, RefusesACheckpointOfAnotherScene) {
  folder.write("scene.yaml", small_scene("{step: 5 ms, duration: 100 ms}", kOutput));
  expect_refused(resume(), "checkpoint.bin: is a checkpoint of another scene");
}

TEST_F(Resume, RefusesACheckpointWithAnotherFill) {
  folder.write("other.json", edited_text(content_of(SceneFolder::example("assumed-cloth.json")),
                                         {{"\"value\": 20", "\"value\": 21"}}));
  std::vector<std::string> command = folder.command({"--resume", "--threads", "1"});
  command[5] = folder.file("other.json");
  expect_refused(run_program(command), "another scene");
}

TEST_F(Resume, GoesOnToTheSameBitsWithAnotherNumberOfThreads) {
  const ProgramRun resumed = resume({"--threads", "2"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  expect_same_files(before, folder.computed_files());
}

TEST_F(Resume, RefusesADamagedCheckpoint) {
  const std::string good = content_of(folder.results() / "checkpoint.bin");
  for (size_t at : {size_t{3}, size_t{40}, size_t{95}, good.size() / 2, good.size() - 1}) {
    std::string flipped = good;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x20);
    folder.write("out/checkpoint.bin", flipped);
    expect_refused(resume(), "checkpoint");
    folder.write("out/checkpoint.bin", good.substr(0, at));
    expect_refused(resume(), "checkpoint");
  }
}

TEST_F(Resume, RefusesAnotherFileInPlaceOfACheckpoint) {
  for (const std::string& other :
       {std::string(), std::string(100'000, '\x81'), content_of(folder.file("scene.yaml"))}) {
    folder.write("out/checkpoint.bin", other);
    expect_refused(resume(), "checkpoint.bin: is no checkpoint");
  }
}

TEST_F(SlowResumed, TakesPeriodsOfCheckpointsThatAreTimes) {
  for (const char* period : {"3", "0 s", "-1 s", "1 mm", "soon"}) {
    const ProgramRun refused = folder.simulate({"--checkpoint-every", period}, "none");
    EXPECT_EQ(refused.status, 2) << period;
    EXPECT_THAT(refused.last_line(), HasSubstr("--checkpoint-every: ")) << period;
    EXPECT_FALSE(std::filesystem::exists(folder.results("none")));
  }
}

}  // namespace
}  // namespace pliant::test
