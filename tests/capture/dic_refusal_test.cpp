// Exports that cannot be used are refused with what was wrong.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/dic_session.h"

#include "capture/point_tables.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::PointTables;
using test::TemporaryFolder;
using ::testing::HasSubstr;

Eigen::Vector3d still(int, const Eigen::Vector2d& place) { return {place.x(), place.y(), 0}; }

constexpr const char* kTwoClips = "clips: [{name: a, side: bottom}, {name: b, side: top}]\n";

std::string refused(const TemporaryFolder& folder, const std::string& more) {
  const auto file = PointTables::describe(folder, more);
  return test::input_error_of([&] { make_dic_session(read_dic(file)); }).what();
}

TEST(DicRefusal, OfARowOfTheLogTooFew) {
  const TemporaryFolder folder;
  PointTables::write(folder, 3, still);
  folder.write("log.csv", "force_N,extension_mm\n0,0\n1,1\n");
  EXPECT_THAT(refused(folder, PointTables::kJaws), HasSubstr("has 2 rows, and there are 3 frames"));
}

TEST(DicRefusal, OfALogThatDoesNotCoverTheFrames) {
  const TemporaryFolder folder;
  PointTables::write(folder, 3, still);
  folder.write("log.csv", "time_s,force_N\n0,0\n1,1\n1.5,2\n");
  const std::string more = std::string(kTwoClips) + "forces: {data: log.csv, on: b, rate: 1 Hz}\n";
  EXPECT_THAT(refused(folder, more), HasSubstr("a log that covers the frames"));
}

TEST(DicRefusal, OfALogWhoseTimesAreShuffled) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  folder.write("log.csv", "time_s,force_N\n0,0\n2,2\n1,1\n");
  const std::string more = std::string(kTwoClips) + "forces: {data: log.csv, on: b, rate: 1 Hz}\n";
  EXPECT_THAT(refused(folder, more), HasSubstr("log.csv:4: time: does not come after the row "
                                               "before; expected times that increase"));
}

TEST(DicRefusal, OfALogWithoutTheExtensionThatAClipMovesBy) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  folder.write("log.csv", "force_N\n0\n1\n");
  EXPECT_THAT(refused(folder, PointTables::kJaws), HasSubstr("has no column of the extension"));
}

TEST(DicRefusal, OfASampleThatThePointsReachOutOf) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  EXPECT_THAT(refused(folder, std::string("weft: -x\n") + kTwoClips),
              HasSubstr("`origin`, `weft`, `warp` and `scale` tell where it lies"));
}

TEST(DicRefusal, OfClipsThatNoPointIsNear) {
  const TemporaryFolder folder;
  const auto places = PointTables::places();
  PointTables::write(folder, 2, still,
                     [&](int, std::size_t p, const std::string& row) -> std::string {
                       return places[p].y() > 0.06 ? "1,1,nan,nan" : row;
                     });
  EXPECT_THAT(refused(folder, kTwoClips),
              HasSubstr("frame 0: no points within 12 mm of the clip b"));
}

TEST(DicRefusal, OfTablesWithoutDisplacementsOrNumbers) {
  const TemporaryFolder folder;
  folder.write("points/0.csv", "x,y\n100,1900\n110,1900\n");
  EXPECT_THAT(refused(folder, kTwoClips), HasSubstr("neither displacements nor numbers"));
}

TEST(DicRefusal, OfOneDisplacementAlone) {
  const TemporaryFolder folder;
  folder.write("points/0.csv", "x,y,u\n100,1900,0\n110,1900,0\n");
  EXPECT_THAT(refused(folder, kTwoClips), HasSubstr("has no column y or v"));
}

TEST(DicRefusal, OfColumnsWithoutUnitOrScale) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  const auto file = folder.write("d.yaml",
                                 "pliant: dic/1\ntest: t\npoints: points/*.csv\n"
                                 "sample: {width: 40 mm, height: 80 mm, mass: 1 g}\n" +
                                     std::string(kTwoClips));
  const InputError error = test::input_error_of([&] { make_dic_session(read_dic(file)); });
  EXPECT_THAT(error.what(), HasSubstr("000.csv:1: x: tells no unit"));
  EXPECT_THAT(error.expected(), HasSubstr("`scale`"));
}

TEST(DicRefusal, OfWordsInCells) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still, [](int, std::size_t p, const std::string& row) {
    return p == 5 ? "1,1,lost,0" : row;
  });
  EXPECT_THAT(refused(folder, kTwoClips), HasSubstr("000.csv:7: u: \"lost\" is no number"));
}

TEST(DicRefusal, OfTooFewPoints) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still,
                     [](int f, std::size_t p, const std::string& row) -> std::string {
                       return f == 1 && p > 5 ? "1,1,," : row;
                     });
  EXPECT_THAT(refused(folder, kTwoClips), HasSubstr("frame 1 has 6 points"));
}

TEST(DicRefusal, OfTwoClipsAtOneSide) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  EXPECT_THAT(refused(folder, "clips: [{name: a, side: top}, {name: b, side: top}]\n"),
              HasSubstr("clips[1].side: is held by another clip"));
}

TEST(DicRefusal, OfForcesOnNoClip) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  folder.write("log.csv", "force_N\n0\n1\n");
  EXPECT_THAT(refused(folder, std::string(kTwoClips) + "forces: {data: log.csv, on: c}\n"),
              HasSubstr("forces.on: \"c\" is no clip"));
}

TEST(DicRefusal, OfFixedTagsInTables) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  EXPECT_THAT(refused(folder, std::string(kTwoClips) + "fixed: [3]\n"),
              HasSubstr("fixed: stand in no picture"));
}

TEST(DicRefusal, OfAFixedTagThatIsOnAClip) {
  const TemporaryFolder folder;
  folder.write("l/0.png", "");
  folder.write("r/0.png", "");
  const auto file = folder.write("d.yaml",
                                 "pliant: dic/1\ntest: t\nviews:\n  calibration: c.json\n"
                                 "  pictures: {left: l/*.png, right: r/*.png}\n"
                                 "  corners: [[0, 9], [9, 9], [9, 0], [0, 0]]\n"
                                 "sample: {width: 40 mm, height: 80 mm, mass: 1 g}\n"
                                 "clips: [{name: a, side: top, labels: [3]}]\nfixed: [4, 3]\n");
  EXPECT_THAT(test::input_error_of([&] { read_dic(file); }).what(),
              HasSubstr("fixed[1]: 3 stands here twice"));
}

TEST(DicRefusal, OfAMeshTooFine) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  EXPECT_THAT(refused(folder, std::string(kTwoClips) + "mesh: 0.1 mm\n"), HasSubstr("401 x 801"));
}

TEST(DicRefusal, OfAClipThatHoldsHalfOfTheSample) {
  const TemporaryFolder folder;
  PointTables::write(folder, 2, still);
  EXPECT_THAT(refused(folder, "clips: [{name: a, side: bottom, depth: 40 mm}]\n"),
              HasSubstr("holds more than there is"));
}

TEST(DicRefusal, OfAClockThatNoMotionTells) {
  const TemporaryFolder folder;
  PointTables::write(folder, 8, still);
  folder.write("log.csv", "time_s,force_N\n0,0\n9,1\n");
  const std::string clips = "clips: [{name: a, side: bottom}, {name: b, side: top}]\n";
  EXPECT_THAT(refused(folder, clips + "forces: {data: log.csv, on: b, start: by motion}\n"),
              HasSubstr("forces.start: needs the `rate`"));
  const std::string forces = "forces: {data: log.csv, on: b, rate: 1 Hz, start: by motion}\n";
  EXPECT_THAT(refused(folder, clips + forces), HasSubstr("has no column of the extension"));
  EXPECT_THAT(
      refused(folder,
              "clips: [{name: a, side: bottom}, {name: b, side: top, motion: held}]\n" + forces),
      HasSubstr("forces.start: is to be found by how the clip moves, which is not seen"));
  folder.write("log.csv", "time_s,force_N,extension_mm\n0,0,0\n9,1,1\n");
  EXPECT_THAT(refused(folder, clips + forces), HasSubstr("forces.start: is not found"));
}

constexpr const char* kViews =
    "pliant: dic/1\ntest: shear\nsample: {width: 40 mm, height: 80 mm, density: 0.1 kg/m^2}\n"
    "clips: [{name: a, side: bottom}]\n";

std::string refused_views(const TemporaryFolder& folder, const std::string& views) {
  for (const char* name : {"left/0.png", "left/1.png", "right/0.png"}) folder.write(name, "");
  const auto file = folder.write("views.yaml", kViews + views);
  return test::input_error_of([&] { read_dic(file); }).what();
}

TEST(DicRefusal, OfUnequalNumbersOfPictures) {
  EXPECT_THAT(refused_views(TemporaryFolder(),
                            "views:\n  calibration: c.json\n  pictures: {left: \"left/*.png\", "
                            "right: \"right/*.png\"}\n  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]"),
              HasSubstr("has 1 pictures, and left has 2"));
}

// Each camera has lost another one.
TEST(DicRefusal, OfPicturesOfDifferentMoments) {
  const TemporaryFolder folder;
  for (const char* name :
       {"left/2.png", "left/4.png", "right/1.png", "right/3.png", "right/4.png"}) {
    folder.write(name, "");
  }
  EXPECT_THAT(refused_views(folder,
                            "views:\n  calibration: c.json\n  pictures: {left: \"left/*.png\", "
                            "right: \"right/*.png\"}\n  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]"),
              HasSubstr("views.yaml:7: views.pictures.right: has 3.png beside 2.png, of another "
                        "moment by the numbers in their names"));
}

TEST(DicRefusal, OfACameraAlone) {
  EXPECT_THAT(refused_views(TemporaryFolder(),
                            "views:\n  calibration: c.json\n  pictures: {left: \"left/*.png\"}\n"
                            "  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]"),
              HasSubstr("less than two cameras"));
}

TEST(DicRefusal, OfACalibrationThatIsNotThere) {
  EXPECT_THAT(refused_views(TemporaryFolder(),
                            "views:\n  calibration: c.json\n  pictures: {left: \"left/0.png\", "
                            "right: \"right/*.png\"}\n  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]"),
              HasSubstr("c.json"));
}

}  // namespace
}  // namespace pliant
