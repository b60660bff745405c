// `pliant import --dic --resume`: pictures that were followed are not followed again.

#include <csignal>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/seen_session.h"

namespace pliant::test {
namespace {

using ::testing::HasSubstr;

/// Pictures by two cameras of a sheet that is pulled, with more squares than they need: long enough
/// to be ended half-way.
class SeenFolder : public TemporaryFolder {
 public:
  SeenFolder() {
    write("lab.yaml",
          fmt::format("pliant: lab/1\nmaterial: {}/examples/assumed-cloth.json\n"
                      "cameras: {{count: 2, picture: 480x520, boards: 8}}\nexperiments:\n"
                      "  - {{name: pull, type: session, test: stretch-warp, size: 60 mm x 60 mm, "
                      "strain: 6 %, frames: 8, mesh: {{edge: 3 mm}}}}\n",
                      PLIANT_SOURCE_DIR));
    EXPECT_EQ(run_on(path(), {"lab", "lab.yaml"}, "lab").status, 0);
    EXPECT_EQ(run_on(path() / "lab" / "pull-seen", {"calibrate", "rig.yaml"}, "calibration").status,
              0);
    std::string text = content_of(file("lab/pull-seen/capture.yaml"));
    const std::string views = "views:\n";
    text.insert(text.find(views) + views.size(), "  step: 3\n");
    write("lab/pull-seen/capture.yaml", text);
  }

  std::string file(const std::string& name) const { return (path() / name).string(); }

  std::vector<std::string> import_to(const std::string& out) const {
    return {"import", "--dic", file("lab/pull-seen/capture.yaml"), "-o", file(out)};
  }

  std::map<std::string, std::string> files_in(const std::string& out) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path() / out)) {
      if (!entry.is_regular_file()) continue;
      files[entry.path().lexically_relative(path() / out).string()] = content_of(entry.path());
    }
    return files;
  }
};

bool is_begun(const std::filesystem::path& file, pid_t child) {
  while (!std::filesystem::exists(file)) {
    siginfo_t ended{};
    const int error = waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (error != 0 || ended.si_pid != 0) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

TEST(SlowImportResume, GoesOnAfterBeingKilledToTheSameBits) {
  const SeenFolder folder;
  ASSERT_EQ(run_program(folder.import_to("whole")).status, 0);
  StartedProgram killed(folder.import_to("made"), {});
  ASSERT_TRUE(is_begun(folder.path() / "made" / "progress.bin", killed.pid()));
  kill(killed.pid(), SIGKILL);
  ASSERT_EQ(killed.wait().status, -SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "made" / "study.yaml"));
  const ProgramRun info = run_program({"info", folder.file("made/progress.bin"), "--json"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_GT(nlohmann::json::parse(info.out)["answers"], 0);

  std::vector<std::string> resume = folder.import_to("made");
  resume.push_back("--resume");
  const ProgramRun resumed = run_program(resume);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_TRUE(folder.files_in("made") == folder.files_in("whole"));
}

TEST(ImportResume, NeedsProgress) {
  const TemporaryFolder folder;
  folder.write("pull.yaml", "pliant: dic/1\n");
  const ProgramRun run = run_program({"import", "--dic", (folder.path() / "pull.yaml").string(),
                                      "-o", (folder.path() / "out").string(), "--resume"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("progress.bin: is not there"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(ImportResume, IsOfPicturesAlone) {
  const TemporaryFolder folder;
  folder.write("strip.png", "");
  const ProgramRun run = run_program({"import", (folder.path() / "strip.png").string(), "-o",
                                      (folder.path() / "out").string(), "--resume"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("--resume: is of pictures that are followed"));
}

}  // namespace
}  // namespace pliant::test
