#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/session/session_type.h"
#include "pliant/measurement/session.h"

#include "support/cloth_sheet.h"
#include "support/virtual_lab.h"

namespace pliant::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

VirtualSessionTest session_of(const std::string& name, const char* test) {
  VirtualSessionTest experiment;
  experiment.name = name;
  experiment.session = usual_session(test);
  experiment.session.frames = 3;
  experiment.session.nodes = std::pair(9, 9);
  experiment.session.noise = {75e-6, 3e-3, 0.1};
  return experiment;
}

VirtualLab sheet_lab() {
  return lab_of(cotton(), {session_of("weft", "stretch-weft"), session_of("frame", "shear"),
                           session_of("table", "bend-warp")});
}

std::string content_of_file(const MeasuredFiles& files, const std::string& name) {
  const auto found = std::ranges::find(files, name, &MeasuredFiles::value_type::first);
  return found == files.end() ? "" : found->second;
}

TEST(VirtualLabSessions, AreDirectoriesThatTheStudyNames) {
  const MeasuredFiles files = measurements_of(sheet_lab());
  const LabFolder folder(files);
  EXPECT_EQ(read_session(folder.path() / "weft").test, "stretch-weft");
  EXPECT_EQ(read_session(folder.path() / "table").test, "bend-warp");
  const std::string study = content_of_file(files, "study.yaml");
  EXPECT_THAT(study, HasSubstr("- name: \"weft\"\n    type: session\n    data: \"weft\"\n"));
  const Study read = folder.study();
  EXPECT_TRUE(spec_of<SessionSpec>(read.experiments[0]).cord_friction.unknown)
      << "the lab lets cords drag";
  EXPECT_FALSE(spec_of<SessionSpec>(read.experiments[2]).cord_friction.unknown)
      << "a table has no cords";
}

TEST(VirtualLabSessions, AreTheSameWithAnyNumberOfThreads) {
  RunContext context;
  const MeasuredFiles one = make_measurements(sheet_lab(), context);
  context.threads = 3;
  EXPECT_TRUE(make_measurements(sheet_lab(), context) == one);
  context.seed = 1;
  const MeasuredFiles other = make_measurements(sheet_lab(), context);
  EXPECT_NE(content_of_file(other, "weft/cords.csv"), content_of_file(one, "weft/cords.csv"));
}

TEST(VirtualLabSessions, HaveADirectoryForEachSpecimen) {
  VirtualLab lab = lab_of(cotton(), session_of("weft", "stretch-weft"));
  lab.specimens = 2;
  lab.specimen_variation = 0.1;
  experiment_of<VirtualSessionTest>(lab, 0).session.noise = {};
  const MeasuredFiles files = measurements_of(lab);
  const std::string first = content_of_file(files, "weft-01/cords.csv");
  EXPECT_FALSE(first.empty());
  EXPECT_NE(first, content_of_file(files, "weft-02/cords.csv")) << "their parameters vary";
  EXPECT_THAT(content_of_file(files, "study.yaml"), HasSubstr("data: \"weft-02\""));
}

TEST(VirtualLabSessions, OfASpecimenAreOfOneMaterial) {
  VirtualLab lab =
      lab_of(cotton(), {session_of("a", "stretch-weft"), session_of("b", "stretch-weft")});
  lab.specimens = 2;
  lab.specimen_variation = 0.1;
  for (std::size_t i = 0; i < 2; ++i) {
    experiment_of<VirtualSessionTest>(lab, i).session.noise = {};
  }
  const MeasuredFiles files = measurements_of(lab);
  const auto cords = [&](const std::string& session) {
    return content_of_file(files, session + "/cords.csv");
  };
  EXPECT_EQ(cords("a-01"), cords("b-01"));
  EXPECT_EQ(cords("a-02"), cords("b-02"));
  EXPECT_NE(cords("a-01"), cords("a-02"));
}

/// Remembers what it is told.
class HeardProgress : public Progress {
 public:
  void begin(std::string_view, double total) override { total_ = total; }
  void advance(double done) override { done_ = done; }
  void end() override {}
  void message(Level, std::string_view text) override { messages_.emplace_back(text); }

  double total_ = 0, done_ = 0;
  std::vector<std::string> messages_;
};

TEST(VirtualLabSessions, TellOfTheirFramesAndWarnings) {
  HeardProgress heard;
  RunContext context{.progress = heard, .stop = {}};
  VirtualLab lab = sheet_lab();
  lab.material.bending_of = "sheet";  // such that no irregular mesh bends like it
  VirtualSession& table = experiment_of<VirtualSessionTest>(lab, 2).session;
  table.nodes.reset();
  table.edge = 0.02;
  lab.material.components.at("bend.diagonal").stiffness = ScalarCurve::constant(1e-8);
  make_measurements(lab, context);
  EXPECT_EQ(heard.total_, 9);
  EXPECT_EQ(heard.done_, 9);
  EXPECT_THAT(heard.messages_, Contains(HasSubstr("table: this mesh cannot bend as")));
}

}  // namespace
}  // namespace pliant::test
