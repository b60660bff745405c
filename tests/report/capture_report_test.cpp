#include "pliant/report/capture_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/sample_capture.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::sample_capture;
using testing::sample_capture_report;

TEST(CaptureReport, SaysWhichFramesAreThereAndWhyOthersAreNot) {
  const std::string page = sample_capture_report();
  EXPECT_THAT(page, HasSubstr("2 of 4 frames are in the session. 1 could not be used. 1 of them "
                              "are to be distrusted."));
  EXPECT_THAT(page, HasSubstr("shows the label 3 not at all"));
  EXPECT_THAT(page, HasSubstr("right &amp; low finds 30 % of what it saw at rest"));
  EXPECT_THAT(page, HasSubstr("the sample lies on something"));
  EXPECT_THAT(page, HasSubstr("no `forces` &lt;told&gt;"));
  EXPECT_THAT(page, HasSubstr("points lie 2 mm apart"));
}

// Lines along weft and warp between vertices that were seen; the middle of a pixel is a half.
TEST(CaptureReport, DrawsTheMeshOverAPicture) {
  EXPECT_THAT(sample_capture_report(), HasSubstr("d=\"M0.5 0.5L2.5 0.5M2.5 0.5L3.5 0.8\""));
}

TEST(CaptureReport, TellsByHowMuchEachCameraMisses) {
  const std::string page = sample_capture_report();
  EXPECT_THAT(page, HasSubstr("left: 0.057 px, mean (0.04, -0.02)"));
  EXPECT_THAT(page, HasSubstr("up to 0.079 px"));
}

// Of the two frames that the session has, with two cords each.
TEST(CaptureReport, DrawsWhatIsLeftOfAllForces) {
  const std::string page = sample_capture_report();
  EXPECT_THAT(page, HasSubstr("<h2>Balance</h2>"));
  EXPECT_THAT(page, HasSubstr(R"("x":[1.0,3.0],"y":[0.0,0.5])"));
  EXPECT_THAT(page, HasSubstr(R"("x":[1.0,3.0],"y":[0.25,0.25])"));
}

TEST(CaptureReport, TellsWhenTheFirstFrameWasTaken) {
  EXPECT_THAT(sample_capture_report(),
              HasSubstr("<dt>First frame</dt><dd>2.4 s by the clock of the forces</dd>"));
  DicSession made = sample_capture();
  made.time.clear();
  EXPECT_THAT(make_capture_report({"pull", made, {}, {}, {}, {}}), Not(HasSubstr("First frame")));
}

TEST(CaptureReport, OfTablesOfPointsJudgesNoFrame) {
  DicSession made = sample_capture();
  made.cameras.clear();
  made.qualities.assign(made.qualities.size(), std::nullopt);
  made.misses.clear();
  const std::string page = make_capture_report({"pull", made, frame_doubts(made), {}, {}, {}});
  EXPECT_THAT(page, HasSubstr("2 of 4 frames are in the session. 1 could not be used.</p>"));
  EXPECT_THAT(page, Not(HasSubstr("Cameras against each other")));
  EXPECT_THAT(page, Not(HasSubstr("The mesh over the pictures")));
}

}  // namespace
}  // namespace pliant
