// Bad sessions: what a study with them does. What is wrong with a single session is the matter of
// tests/experiment/session.

#include <filesystem>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"
#include "pliant/material/material_file.h"

#include "app/run_program.h"
#include "support/virtual_sheets.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr char kMaterial[] = PLIANT_SOURCE_DIR "/examples/assumed-cloth.json";

/// A study of sessions, the first of which a case may spoil.
class SheetStudy {
 public:
  explicit SheetStudy(const std::string& options = "") {
    folder_.write("study.yaml", fmt::format("pliant: study/1\nname: test\nexperiments:\n"
                                            "  - {{name: pull, type: session, data: pull{}}}\n"
                                            "model: {{mesh: measured}}\n",
                                            options));
  }

  void write(const std::string& name, const Session& session) const {
    for (const auto& [file, content] : session_files(session)) {
      folder_.write(name + "/" + file, content);
    }
  }
  ProgramRun run(const std::vector<std::string>& command) const {
    std::vector<std::string> words = command;
    words.insert(words.begin() + 1, study());
    return run_program(words);
  }
  ProgramRun evaluate() const { return run({"evaluate", "-m", kMaterial, "-o", output()}); }

  std::string study() const { return (folder_.path() / "study.yaml").string(); }
  std::string output() const { return (folder_.path() / "out").string(); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

Session pulled_sheet(int frames = 4) { return virtual_stretch(sheet_cloth(false), 0, 7, frames); }

struct BadSession {
  std::string name;
  std::string options;  ///< of the experiment
  void (*spoil)(Session& session);
  std::vector<std::string> says;

  friend void PrintTo(const BadSession& bad, std::ostream* out) { *out << bad.name; }
};

class RefusedSession : public ::testing::TestWithParam<BadSession> {};

TEST_P(RefusedSession, ByTheStudyAtItsLine) {
  const BadSession& bad = GetParam();
  const SheetStudy study(bad.options);
  Session session = pulled_sheet();
  bad.spoil(session);
  study.write("pull", session);
  const ProgramRun run = study.evaluate();
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_FALSE(std::filesystem::exists(study.output()));
  EXPECT_THAT(run.last_line(), StartsWith("error: " + study.study() + ":4: "));
  for (const std::string& words : bad.says) EXPECT_THAT(run.last_line(), HasSubstr(words));
}

void without_cords(Session& session) {
  for (SessionFrame& frame : session.frames) {
    for (auto& cords : frame.cords) cords.clear();
  }
}

const BadSession kBadSessions[] = {
    {"WithForcesOfZero",
     "",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) {
         for (auto& cords : frame.cords) cords.front().force.setZero();
       }
     },
     {"all forces of cords in the session of pull are zero", "expected forces in newtons"}},
    {"WithoutForces",
     ", objective: clip-forces",
     without_cords,
     {"has no forces of cords to compare", "expected rows in cords.csv"}},
    {"WithoutAnythingThatHolds",
     "",
     [](Session& session) {
       session.clips.clear();
       for (SessionFrame& frame : session.frames) {
         frame.poses.clear();
         frame.cords.clear();
       }
     },
     {"nothing holds the sheet of pull", "expected a session with `clips` or a `table`"}},
    {"WithAClipOfOneVertex",
     ", objective: parallel-clip-forces",
     [](Session& session) { session.clips[0].clamped.resize(1); },
     {"clip clip0 of pull clamps one vertex", "expected two vertices at least"}},
    {"WithoutASecondClip",
     ", objective: axial-clip-forces",
     [](Session& session) {
       session.clips.pop_back();
       for (SessionFrame& frame : session.frames) {
         frame.poses.pop_back();
         frame.cords.pop_back();
       }
     },
     {"no second clip", "expected two clips at least"}},
};

INSTANTIATE_TEST_SUITE_P(Table, RefusedSession, ::testing::ValuesIn(kBadSessions),
                         [](const auto& bad) { return bad.param.name; });

TEST(DoubtfulStudy, WarnsOfASecondFabric) {
  const SheetStudy study;
  study.folder().write("study.yaml",
                       "pliant: study/1\nname: test\nexperiments:\n"
                       "  - {name: pull, type: session, data: pull}\n"
                       "  - {name: other, type: session, data: other}\n"
                       "model: {mesh: measured}\n");
  Session other = pulled_sheet();
  study.write("pull", other);
  other.sample.density = 0.3;
  study.write("other", other);
  const ProgramRun run = study.evaluate();
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("other: its sheet weighs 300 g/m^2"));
  EXPECT_THAT(run.err, HasSubstr("is it the same fabric?"));
}

TEST(SheetStudyInfo, SaysWhatWillBeCompared) {
  const SheetStudy study(", cord_friction: unknown");
  study.write("pull", pulled_sheet());
  const ProgramRun run = study.run({"info"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("clip-forces, 8 forces in 4 frames, clips clip0, clip1"));
  EXPECT_THAT(run.out, HasSubstr("friction unknown: estimated along for each cord"));

  const SheetStudy shapes(", objective: positions");
  shapes.write("pull", pulled_sheet());
  // 3 of 7 columns are free, of 7 vertices each.
  EXPECT_THAT(shapes.run({"info"}).out,
              AllOf(HasSubstr("positions, 84 free vertices in 4 frames, between the clips"),
                    Not(HasSubstr("friction taken"))));
}

TEST(SheetStudyFit, RefusesWhatOnlyFitsOfStripsHeed) {
  const SheetStudy study;
  study.write("pull", pulled_sheet());
  for (const auto& [option, value] :
       {std::pair{"--profile", "*"}, std::pair{"--compare", "laws"}}) {
    const ProgramRun run = study.run({"fit", "-o", study.output(), option, value});
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_THAT(run.last_line(), StartsWith(std::string("error: ") + option + ": "));
    EXPECT_THAT(run.last_line(), HasSubstr("the laws of strips, and the study fits none"));
  }
}

/// Two clips side by side in the sheet, which come to lie on each other in one frame of six: the
/// triangles between them have no shape left, and no equilibrium.
Session crushed_sheet() {
  Session session = clamped_sheet("corner-pull", 9, {{4, 13, 22}, {5, 14, 23}});
  const double apart = session.rest.positions(0, 5) - session.rest.positions(0, 4);
  for (int f = 0; f < 6; ++f) {
    SessionFrame frame;
    frame.poses.resize(2);
    frame.poses[1].translation.x() = f == 2 ? -apart : 2e-4 * f;
    frame.positions = session.rest.positions;
    for (const int node : session.clips[1].clamped) {
      frame.positions.col(node) = frame.poses[1].apply(session.rest.positions.col(node));
    }
    frame.cords.resize(2);
    frame.cords[1] = {{"", frame.positions.col(14), {0.1 * f, 0, 0.1}}};
    session.frames.push_back(frame);
  }
  return session;
}

TEST(CrushedFrame, IsLeftOutOfThePredictionAndNamed) {
  const SheetStudy study;
  study.write("pull", crushed_sheet());
  const std::string material =
      study.folder().write("material.json", material_text(sheet_cloth(false))).string();
  const ProgramRun run = study.run({"evaluate", "-m", material, "-o", study.output()});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("pull: no equilibrium is found of frame 2 (of 6)"));
  const std::filesystem::path results = study.output();
  const auto result = nlohmann::json::parse(read_text_file(results / "evaluation.json"));
  const auto& experiment = result["experiments"][0];
  EXPECT_EQ(experiment["missing_frames"], nlohmann::json::array({2}));
  EXPECT_EQ(experiment["points"], 5);
  EXPECT_EQ(experiment["excluded"], 1);
  EXPECT_TRUE(experiment["rms_force_N"].is_number());
  EXPECT_FALSE(std::filesystem::exists(results / "sheets/pull/predicted/frames/0005.ply"));
  EXPECT_EQ(run_program({"report", results.string()}).status, 0);
}

TEST(UnseenVertices, AreLeftOutOfAStudyOfPositions) {
  const SheetStudy study(", objective: positions");
  Session session = pulled_sheet();
  session.frames[1].unseen = {24};
  session.frames[2].unseen = {24, 25};
  study.write("pull", session);
  const ProgramRun run = study.evaluate();
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("in 2 of 4 frames vertices were not seen, most in frame 2"));
  const auto result = nlohmann::json::parse(
      read_text_file(std::filesystem::path(study.output()) / "evaluation.json"));
  EXPECT_EQ(result["experiments"][0]["points"], 84 - 3);
}

}  // namespace
}  // namespace pliant::test
