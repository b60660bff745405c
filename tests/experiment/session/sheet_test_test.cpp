#include "pliant/experiment/session/sheet_test.h"

#include <gtest/gtest.h>

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

TEST(UsualObjective, OfAShearIsTheForcesAlongTheClips) {
  Session session = stretch_session();
  session.test = "shear";
  EXPECT_EQ(usual_objective(session), SheetObjective::parallel_clip_forces);
}

TEST(UsualObjective, BetweenClipsThatCordsPullIsTheirForces) {
  Session session = stretch_session();
  for (const char* test : {"stretch-weft", "stretch-warp", "corner-pull", "of its own"}) {
    session.test = test;
    EXPECT_EQ(usual_objective(session), SheetObjective::clip_forces) << test;
  }
}

TEST(UsualObjective, OverATableOrBetweenClipsWithoutCordsIsPositions) {
  EXPECT_EQ(usual_objective(bend_session()), SheetObjective::positions);
  Session session = stretch_session();
  for (SessionFrame& frame : session.frames) {
    for (auto& cords : frame.cords) cords.clear();
  }
  EXPECT_EQ(usual_objective(session), SheetObjective::positions);
}

// As the errors of cameras are: twice as large out of the plane.
TEST(SheetTest, WeighsPositionsByHowSureTheyAre) {
  Session session = test::bend_session();
  const double sure = 2e-5, unsure = 4e-5;
  for (SessionFrame& frame : session.frames) {
    frame.deviations = Eigen::Matrix3Xd::Constant(3, frame.positions.cols(), sure);
    frame.deviations.row(2).setConstant(unsure);
  }
  const SheetTest sheet("bend", session, SheetObjective::positions);
  const Eigen::ArrayXd weights = sheet.weights(1);
  EXPECT_NEAR(weights(0), 2 * weights(2), 1e-12);
  EXPECT_NEAR(weights.mean(), 1, 1e-12);
  // A row that counts 1 lies in between.
  EXPECT_NEAR(*sheet.stated_noise(), 3 / (2 / sure + 1 / unsure), 1e-18);

  session.frames[0].deviations.resize(3, 0);
  EXPECT_EQ(SheetTest("bend", session, SheetObjective::positions).weights(1).maxCoeff(), 1);
}

}  // namespace
}  // namespace pliant::test
