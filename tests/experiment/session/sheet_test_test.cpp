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

}  // namespace
}  // namespace pliant::test
