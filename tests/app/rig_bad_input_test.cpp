// Captures by a rig of cameras in which something went wrong: what `pliant import` says of them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/imaging/photo.h"

#include "app/picture_png.h"
#include "app/seen_session.h"

namespace pliant::test {
namespace {

using ::testing::HasSubstr;

/// A picture that is another one while the test looks at it.
class SpoiledPicture {
 public:
  SpoiledPicture(const std::filesystem::path& file,
                 const std::function<GreyPicture(const GreyPicture&)>& spoil)
      : file_(file), before_(content_of(file)) {
    const std::string spoiled = png_of(spoil(read_photo(file)));  // before the file is emptied
    std::ofstream(file_, std::ios::binary) << spoiled;
  }
  ~SpoiledPicture() { std::ofstream(file_, std::ios::binary) << before_; }
  SpoiledPicture(const SpoiledPicture&) = delete;
  SpoiledPicture& operator=(const SpoiledPicture&) = delete;

 private:
  std::filesystem::path file_;
  std::string before_;
};

GreyPicture over_exposed(const GreyPicture& picture) { return (picture + 0.43F).min(1.0F); }

/// What it shows is elsewhere, by whole pixels.
GreyPicture shifted(const GreyPicture& picture, Eigen::Index right, Eigen::Index down) {
  GreyPicture result(picture.rows(), picture.cols());
  for (Eigen::Index row = 0; row < picture.rows(); ++row) {
    for (Eigen::Index column = 0; column < picture.cols(); ++column) {
      result(row, column) =
          picture(std::clamp<Eigen::Index>(row - down, 0, picture.rows() - 1),
                  std::clamp<Eigen::Index>(column - right, 0, picture.cols() - 1));
    }
  }
  return result;
}

GreyPicture shaken(const GreyPicture& picture) { return shifted(picture, 2, 0); }

/// The mean of five by five pixels.
GreyPicture out_of_focus(const GreyPicture& picture) {
  GreyPicture sum = GreyPicture::Zero(picture.rows(), picture.cols());
  for (Eigen::Index right = -2; right <= 2; ++right) {
    for (Eigen::Index down = -2; down <= 2; ++down) sum += shifted(picture, right, down);
  }
  return sum / 25;
}

/// A bright line where nothing is.
GreyPicture scratched(const GreyPicture& picture) {
  GreyPicture result = picture;
  result.block(200, 19, 100, 3).setConstant(0.9F);
  return result;
}

std::filesystem::path picture_of(const std::filesystem::path& seen, int camera, int frame) {
  return seen / "pictures" / ("camera" + std::to_string(camera)) /
         ("00" + std::to_string(frame) + ".png");
}

/// Where `picture` and `along` of a cell stand in a capture.yaml.
std::pair<std::size_t, std::size_t> pointed_in(const std::string& text, int cell) {
  std::size_t at = text.find("cells:");
  for (int i = 0; i <= cell; ++i) at = text.find("picture: ", at + 1);
  return {at, text.find('}', at) - at};
}

/// Imports what a rig saw, but for one cell that points to something else.
ProgramRun import_pointed(const std::filesystem::path& seen, int cell, const std::string& pointed) {
  std::string text = content_of(seen / "capture.yaml");
  const auto [at, size] = pointed_in(text, cell);
  std::ofstream(seen / "pointed.yaml") << text.replace(at, size, pointed);
  return run_on(seen, {"import", "--dic", "pointed.yaml"}, "pointed");
}

void expect_cells_that_point_beside_their_cord_refused(const std::filesystem::path& seen) {
  const std::string text = content_of(seen / "capture.yaml");
  const auto [at, size] = pointed_in(text, 0);
  const ProgramRun twice = import_pointed(seen, 1, text.substr(at, size));
  EXPECT_EQ(twice.status, 2);
  EXPECT_THAT(twice.err,
              HasSubstr("points to the cord of another cell, the cord 1 of the clip bottom"));

  const ProgramRun none =
      import_pointed(seen, 2, "picture: pictures/camera1/001.png, along: [[20, 200], [20, 300]]");
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("pointed.yaml:21: forces.cells[2]: points to no cord"));

  const SpoiledPicture line(picture_of(seen, 2, 1), scratched);
  const ProgramRun one =
      import_pointed(seen, 0, "picture: pictures/camera2/001.png, along: [[20, 205], [20, 295]]");
  EXPECT_EQ(one.status, 2);
  EXPECT_THAT(one.err, HasSubstr("pointed.yaml:19: forces.cells[0]: points to a cord that no other "
                                 "camera than camera2 sees"));
}

/// One that the second camera took a frame later.
void expect_pictures_of_different_moments_named(const std::filesystem::path& seen) {
  const SpoiledPicture late(picture_of(seen, 2, 2),
                            [&](const GreyPicture&) { return read_photo(picture_of(seen, 2, 1)); });
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "remade");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("1 frames are left out: frame 2 shows points on "));
  EXPECT_TRUE(std::filesystem::exists(seen / "remade" / "frames.csv"));
  const std::string report = content_of(seen / "remade" / "quality.html");
  EXPECT_THAT(report, HasSubstr("2 of 4 frames are in the session. 1 could not be used."));
  EXPECT_THAT(report, HasSubstr("camera2, frame 3"));
  EXPECT_THAT(report, HasSubstr("Cameras against each other"));
  EXPECT_THAT(report, HasSubstr("the sample lies on something"));
  EXPECT_THAT(report, HasSubstr("pictures were of different moments"));
}

void expect_bad_pictures_named(const std::filesystem::path& seen) {
  const SpoiledPicture white(picture_of(seen, 1, 1), over_exposed);
  const SpoiledPicture blurred(picture_of(seen, 2, 2), out_of_focus);
  const SpoiledPicture moved(picture_of(seen, 3, 3), shaken);
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "spoiled");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("2 frames are to be distrusted, first frame 1: the picture "
                                      "of camera1 is over-exposed"));
  const std::string report = content_of(seen / "spoiled" / "quality.html");
  const auto row = [](const std::string& frame, const std::string& what, const std::string& why) {
    return HasSubstr("<td class=\"number\">" + frame + "</td><td>" + what + "</td><td>" + why);
  };
  EXPECT_THAT(report, row("1", "to be distrusted", "the picture of camera1 is over-exposed"));
  EXPECT_THAT(report, row("2", "to be distrusted", "the picture of camera2 is blurred"));
  EXPECT_THAT(report, row("3", "left out", "shows points on "));
}

void expect_moved_camera_refused(const std::filesystem::path& seen) {
  const SpoiledPicture first(picture_of(seen, 3, 1), shaken);
  const SpoiledPicture second(picture_of(seen, 3, 2), shaken);
  const SpoiledPicture third(picture_of(seen, 3, 3), shaken);
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "moved");
  EXPECT_EQ(imported.status, 2);
  EXPECT_THAT(imported.err, HasSubstr("no frame can be used: frame 1 shows points on "));
  EXPECT_THAT(imported.err, HasSubstr("as if one had been moved"));
}

TEST(SlowRigBadInput, OfCordsAndOfPicturesIsNamedWithItsReason) {
  const TemporaryFolder folder;
  const std::string lab = PLIANT_SOURCE_DIR "/examples/virtual-rig/lab.yaml";
  ASSERT_EQ(run_program({"lab", lab, "-o", (folder.path() / "lab").string()}).status, 0);
  const auto seen = folder.path() / "lab" / "stretch-seen";
  ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
  expect_cells_that_point_beside_their_cord_refused(seen);
  expect_pictures_of_different_moments_named(seen);
  expect_bad_pictures_named(seen);
  expect_moved_camera_refused(seen);
}

}  // namespace
}  // namespace pliant::test
