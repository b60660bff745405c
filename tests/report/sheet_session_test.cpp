#include "pliant/report/sheet_session.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "report/sample_results.h"
#include "report/sample_sheets.h"

namespace pliant::report {
namespace {

using testing::hanging_sheet;
using testing::kSheetNodes;
using testing::stretched_sheet;
using testing::TemporaryFolder;
using testing::with_residuals;

constexpr double kRounding = 1e-12;

TEST(SheetSession, NodesInClipsAndOnTheTableAreNotFree) {
  EXPECT_EQ(free_nodes(stretched_sheet(2, 1e-3, 100), 1).size(), (kSheetNodes - 4) * kSheetNodes);
  EXPECT_EQ(free_nodes(hanging_sheet(2), 1).size(), kSheetNodes / 2 * kSheetNodes);
}

TEST(SheetSession, TheRmsDistanceIsThatOfTheFreeNodesInAllFrames) {
  SheetSession sheet = with_residuals(stretched_sheet(2, 1e-3, 100), 3e-3, 0);
  EXPECT_NEAR(rms_distance(sheet), 3e-3, kRounding);
  sheet.predicted.frames[0].positions = sheet.measured.frames[0].positions;
  EXPECT_NEAR(rms_distance(sheet, 0), 0, kRounding);
  EXPECT_NEAR(rms_distance(sheet, 1), 3e-3, kRounding);
  EXPECT_NEAR(rms_distance(sheet), 3e-3 / std::sqrt(2.0), kRounding);
}

TEST(SheetSession, ASheetIsMostDistortedWhereItsClipsAreFarthestApart) {
  Session session = stretched_sheet(5, 2e-3, 100);
  std::swap(session.frames[2], session.frames[4]);
  for (const int node : free_nodes(session, 0)) session.frames[0].positions(2, node) -= 0.02;
  EXPECT_EQ(most_distorted_frame(session), 2);
}

TEST(SheetSession, ASheetOnATableIsMostDistortedWhereItFallsSteepest) {
  Session session = hanging_sheet(4);
  std::swap(session.frames[1], session.frames[3]);
  EXPECT_EQ(most_distorted_frame(session), 1);
}

TEST(SheetSession, MovingRigidlyIsNoDistortion) {
  Session session = stretched_sheet(2, 1e-4, 100);
  SessionFrame& moved = session.frames[0];
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  moved.positions = ((turn * moved.positions).colwise() + Eigen::Vector3d(0.1, 0.2, 0.3)).eval();
  EXPECT_EQ(most_distorted_frame(session), 1);
}

TEST(SheetSession, AxesOfOneForceCountAsOneForce) {
  const TemporaryFolder folder;
  testing::write_text(folder.path() / "forces.csv",
                      "frame,clip,axis,measured_force_N,predicted_force_N\n"
                      "0,left,x,1,1.3\n0,left,y,0,0.4\n0,right,x,2,2\n0,right,y,2,2\n");
  EXPECT_NEAR(rms_clip_force(folder.path() / "forces.csv"), std::sqrt(0.25 / 2), kRounding);
}

TEST(SheetSession, IsReadBackAsItWasWritten) {
  const TemporaryFolder folder;
  const SheetSession sheet = with_residuals(stretched_sheet(3, 1e-3, 100), 1e-3, 0.1);
  write_session(folder.path() / "measured", sheet.measured);
  write_session(folder.path() / "predicted", sheet.predicted);
  EXPECT_EQ(rms_distance(read_sheet_session(folder.path())), rms_distance(sheet));
}

TEST(SheetSession, RefusesThePredictionOfAnotherSession) {
  const TemporaryFolder folder;
  write_session(folder.path() / "measured", stretched_sheet(3, 1e-3, 100));
  write_session(folder.path() / "predicted", stretched_sheet(2, 1e-3, 100));
  EXPECT_THROW(read_sheet_session(folder.path()), InputError);
}

}  // namespace
}  // namespace pliant::report
