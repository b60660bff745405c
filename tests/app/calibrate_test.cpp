// Virtual cameras draw a board; the program finds the cameras again, and says what is wrong with
// pictures that do not do.

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/capture/calibration_file.h"

#include "app/picture_png.h"
#include "app/run_program.h"
#include "capture/board_drawing.h"
#include "capture/texture.h"

namespace pliant::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kBoardFile =
    "pliant: pattern/1\n"
    "board: {columns: 5, rows: 4, tag: 16 mm, gap: 5 mm, first_code: 0}\n";
const TagBoard kBoard{5, 4, 0.016, 0.005, 0};
constexpr const char* kRigFile =
    "pliant: rig/1\n"
    "cameras:\n"
    "  left: {distortion: k1}\n"
    "  right: {distortion: k1}\n"
    "calibration:\n"
    "  boards: board.yaml\n"
    "  pictures: {left: left*.png, right: right*.png}\n";

std::vector<CameraModel> two_cameras() {
  CameraModel left;
  left.columns = 400;
  left.rows = 320;
  left.intrinsics << 640, 640, 201, 158, -0.15, 0, 0, 0, 0;
  CameraModel right = left;
  right.pose = {{0, 0.3, 0}, {-0.09, 0, 0.015}};
  return {left, right};
}

RigidMotion placement(int shot) {
  const double along = shot % 3 - 1, up = shot / 3 - 1;
  const RigidMotion turn{{0.5 * up + 0.1, 0.5 * along - 0.15, 0.1 * along},
                         {0.02 * along, 0.02 * up, 0.3 + 0.02 * along * up}};
  const RigidMotion face{{3.141592653589793, 0, 0}, {0, 0, 0}};
  return turn * face * RigidMotion{{0, 0, 0}, {-0.05, -0.04, 0}};
}

void draw_pictures(const TemporaryFolder& folder, int shots) {
  RandomStream random(1);
  for (int shot = 0; shot < shots; ++shot) {
    const std::vector<CameraModel> cameras = two_cameras();
    for (int c = 0; c < 2; ++c) {
      GreyPicture picture = draw_board(cameras[c], kBoard, placement(shot), 0.7);
      add_noise(picture, 0.01, random);
      folder.write(fmt::format("{}{}.png", c == 0 ? "left" : "right", shot), png_of(picture));
    }
  }
}

ProgramRun calibrate(const TemporaryFolder& folder, const std::string& rig) {
  folder.write("board.yaml", kBoardFile);
  const auto file = folder.write("rig.yaml", rig);
  return run_program({"calibrate", file.string(), "-o", (folder.path() / "out").string()});
}

TEST(SlowCalibrateCommand, FindsVirtualCamerasInTheirPictures) {
  const TemporaryFolder folder;
  draw_pictures(folder, 9);
  folder.write("left9.png", png_of(GreyPicture::Constant(320, 400, 0.5f)));
  folder.write("right9.png", png_of(GreyPicture::Constant(300, 400, 0.5f)));
  const ProgramRun run = calibrate(folder, kRigFile);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("left9.png is left out: shows no board"));
  EXPECT_THAT(run.err, HasSubstr("right9.png is left out: is of 400 x 300 pixels"));
  EXPECT_THAT(run.err, HasSubstr("no second known length"));
  const CalibratedRig found = read_calibration(folder.path() / "out" / "calibration.json");
  ASSERT_EQ(found.names, (std::vector<std::string>{"left", "right"}));
  const std::vector<CameraModel> cameras = two_cameras();
  for (int c = 0; c < 2; ++c) {
    EXPECT_LT(found.rms[c], 0.12);
    // Corners of tags of 32 pixels are off by 0.05 pixels at most, together.
    EXPECT_NEAR(found.cameras[c].intrinsics(0), 640, 2);
    EXPECT_NEAR(found.cameras[c].intrinsics(4), -0.15, 0.02);
  }
  EXPECT_LT((found.cameras[1].centre() - cameras[1].centre()).norm(), 3e-4);
  const ProgramRun info =
      run_program({"info", (folder.path() / "out" / "calibration.json").string()});
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("calibration/1"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "corners.csv"));
}

TEST(CalibrateCommand, RefusesUnequalCountsOfPictures) {
  const TemporaryFolder folder;
  for (const char* name : {"left0.png", "left1.png", "right0.png"}) folder.write(name, "");
  const ProgramRun run = calibrate(folder, kRigFile);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("rig.yaml:7: calibration.pictures.right: are 1 pictures, and "
                                 "left has 2"));
}

TEST(CalibrateCommand, RefusesPicturesThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const char* name : {"left0.png", "right0.png"}) folder.write(name, "no picture");
  const ProgramRun run = calibrate(folder, kRigFile);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("rig.yaml:3: cameras.left: has no picture that could be used"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "calibration.json"));
}

TEST(CalibrateCommand, RefusesWhatTheBoardsThemselvesTellAsSecondLength) {
  const TemporaryFolder folder;
  for (const char* name : {"left0.png", "right0.png"}) folder.write(name, "");
  const ProgramRun run = calibrate(
      folder, std::string(kRigFile) + "  second_length: {codes: [3, 100], distance: 10 cm}\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("3 is a code of board.yaml"));
}

TEST(CalibrateCommand, RefusesACameraThatIsNotNamed) {
  const TemporaryFolder folder;
  const ProgramRun run = calibrate(folder,
                                   "pliant: rig/1\ncameras: {left: }\ncalibration:\n"
                                   "  boards: board.yaml\n  pictures: {rigth: a.png}\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err,
              HasSubstr("calibration.pictures.rigth: is a camera that `cameras` does not"));
}

TEST(CalibrateCommand, RefusesAPatternThatIsNoBoard) {
  const TemporaryFolder folder;
  folder.write("clips.yaml", "pliant: pattern/1\nclips: {tag: 15 mm, edge: 15 mm, codes: [0]}\n");
  const ProgramRun run = calibrate(folder,
                                   "pliant: rig/1\ncameras: {left: }\ncalibration:\n"
                                   "  boards: clips.yaml\n  pictures: {left: a.png}\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("is a pattern of kind `clips`"));
}

}  // namespace
}  // namespace pliant::test
