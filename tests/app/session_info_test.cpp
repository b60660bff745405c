// `pliant info` of a session.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pliant/file_info.h"
#include "io/input_error_of.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST(SessionInfo, TellsWhatWasMeasured) {
  const SessionFolder folder(stretch_session());
  const FileInfo info = describe_file(folder.path());
  EXPECT_EQ(info.json["type"], "session/1");
  EXPECT_EQ(info.json["test"], "stretch-weft");
  EXPECT_EQ(info.json["sample"]["id"], "12");
  EXPECT_EQ(info.json["vertices"], 81);
  EXPECT_EQ(info.json["triangles"], 128);
  EXPECT_EQ(info.json["frames"], 3);
  EXPECT_EQ(info.json["time"]["max"], 4);
  EXPECT_EQ(info.json["clips"][1]["clamped"], 9);
  // Two cords pull with 4 N each in the last frame and carry a quarter of the weight.
  const double weight = (0.0031 + 2 * 0.0101) * 9.80665;
  EXPECT_NEAR(info.json["force"]["max"].get<double>(), std::hypot(4, weight / 4), 1e-12);
  EXPECT_NEAR(info.json["force"]["min"].get<double>(), weight / 4, 1e-12);
  EXPECT_LT(info.json["largest_imbalance"]["force"].get<double>(), 1e-12);
  EXPECT_THAT(info.lines,
              Contains(HasSubstr("81 vertices, 128 triangles, 100 mm x 100 mm at rest")));
  EXPECT_THAT(info.lines, Contains(HasSubstr("12, 100 mm x 100 mm, 3.1 g, 310 g/m^2")));
  EXPECT_THAT(info.warnings, IsEmpty());
}

TEST(SessionInfo, TellsHowWellPositionsAreKnownWhereEveryFrameDoes) {
  Session session = stretch_session();
  const Eigen::Vector3d known(2e-6, 3e-6, 9e-6);
  const Eigen::Index vertices = session.rest.vertex_count();
  for (SessionFrame& frame : session.frames) frame.deviations = known.replicate(1, vertices);
  session.frames[0].deviations.col(7) *= 50;  // the middle is told
  const FileInfo info = describe_file(SessionFolder(session).path());
  ASSERT_EQ(info.json["position_deviation"].size(), 3U);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double told = info.json["position_deviation"][axis].get<double>();
    EXPECT_NEAR(told, known(static_cast<Eigen::Index>(axis)), 1e-15);
  }
  EXPECT_THAT(info.lines, Contains(AllOf(StartsWith("positions"),
                                         HasSubstr("to 2 um, 3 um, 9 um along x, y, z"))));

  session.frames[1].deviations.resize(3, 0);
  EXPECT_THAT(describe_file(SessionFolder(session).path()).lines,
              Not(Contains(HasSubstr("along x, y, z"))));
}

TEST(SessionInfo, NamesTheLargestImbalance) {
  Session session = stretch_session();
  session.frames[1].cords[0][0].force.x() += 0.7;
  const SessionFolder folder(session);
  const FileInfo info = describe_file(folder.path());
  EXPECT_EQ(info.json["largest_imbalance"]["frame"], 1);
  EXPECT_NEAR(info.json["largest_imbalance"]["force"].get<double>(), 0.7, 1e-12);
  EXPECT_THAT(info.warnings, Contains(HasSubstr("frame 1")));
  EXPECT_EQ(info.json["warnings"].size(), info.warnings.size());
}

TEST(SessionInfo, KnowsTheTableOfABendTest) {
  const SessionFolder folder(bend_session());
  const FileInfo info = describe_file(folder.path() / "session.yaml");
  EXPECT_EQ(info.json["table"]["axis"], "y");
  EXPECT_NEAR(info.json["table"]["edge"]["max"].get<double>(), 0.078, 1e-15);
  EXPECT_TRUE(info.json["largest_imbalance"].is_null());
  EXPECT_TRUE(info.json["force"].is_null());
}

TEST(SessionInfo, RefusesWhatTheReaderRefuses) {
  const SessionFolder folder(stretch_session());
  folder.remove("frames/0001.ply");
  const InputError error = input_error_of([&] { describe_file(folder.path()); });
  EXPECT_EQ(error.where().file, folder.file("frames/0001.ply"));
}

}  // namespace
}  // namespace pliant::test
