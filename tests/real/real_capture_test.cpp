// Pictures of boards and tags by real cameras; skipped where PLIANT_TEST_DATA does not hold them.
// The lines they print are those of the documentation.

#include "real/real_capture.h"

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/chessboard_corners.h"
#include "pliant/capture/dic_session.h"
#include "pliant/capture/rig_calibration.h"
#include "pliant/imaging/photo.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"
#include "real/real_fit.h"

namespace pliant::test {
namespace {

// Asked for are a stereo RMS of 0.28 pixels, 0.15 from epipolar lines, and held-out boards that are
// rigid to 0.026 squares, with all nine pairs.
TEST(RealCapture, StereoChessboardIsMetWithAllNinePairs) {
  const auto folder = measurement("stereo_chessboard");
  SKIP_WITHOUT(folder);
  if (!can_find_chessboards()) GTEST_SKIP() << "needs OpenCV's calib3d";
  constexpr int kColumns = 9, kRows = 6;
  const RigCalibration found = calibrated(
      fmt::format("{{columns: {}, rows: {}, square: 1 m}}", kColumns, kRows), "{left: , right: }",
      fmt::format("{{left: {0}/left*.jpg, right: {0}/right*.jpg}}", folder.string()));
  EXPECT_EQ(left_out_pictures(found), 0);
  double squares = 0, all_squares = 0;
  int corners = 0, all = 0, outermost = 0;
  for (const CameraResiduals& camera : found.cameras) {
    squares += camera.rms * camera.rms * camera.corners;
    corners += camera.corners;
    all += camera.corners + camera.left_out;
    all_squares += camera.rms_all * camera.rms_all * (camera.corners + camera.left_out);
  }
  for (const CornerView& view : found.bundle.views) {
    for (std::size_t i = 0; i < view.corners.size(); ++i) {
      const int column = view.corners[i] % kColumns, row = view.corners[i] / kColumns;
      const bool is_outermost =
          column == 0 || column == kColumns - 1 || row == 0 || row == kRows - 1;
      outermost += is_outermost && !view.is_used[i];
    }
  }
  EXPECT_EQ(outermost, all - corners);  // what was left out is at the rim of the board
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_TRUE(found.held_out);
  fmt::print(
      "stereo RMS {:.3f} px of {} corners, {:.3f} px of all {}; {:.3f} px from epipolar "
      "lines; {} boards held out, rigid to {:.4f} squares\n",
      std::sqrt(squares / corners), corners, std::sqrt(all_squares / all), all, found.pairs[0].rms,
      found.held_out->boards, found.held_out->rms);
  EXPECT_LT(std::sqrt(squares / corners), 0.28);
  EXPECT_GT(corners, 0.94 * all);
  EXPECT_LT(found.pairs[0].rms, 0.15);
  EXPECT_EQ(found.held_out->boards, 9);
  EXPECT_LT(found.held_out->rms, 0.026);
}

struct ListedTag {
  int code = 0;
  Eigen::Matrix<double, 2, 4> corners;
};

// `code, (x y), (x y), (x y), (x y)`, the corner of the first pixel being (0, 0).
std::vector<ListedTag> listed_tags(const std::filesystem::path& file) {
  std::vector<ListedTag> tags;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    for (char& c : line) {
      if (c == ',' || c == '(' || c == ')') c = ' ';
    }
    std::istringstream numbers(line);
    ListedTag tag;
    numbers >> tag.code;
    for (int i = 0; i < 4; ++i) numbers >> tag.corners(0, i) >> tag.corners(1, i);
    if (!numbers) continue;
    tag.corners.array() -= 0.5;
    tags.push_back(tag);
  }
  return tags;
}

TEST(RealCapture, TagsOfPhotographsAreFound) {
  const auto folder = measurement("apriltag_photos");
  SKIP_WITHOUT(folder);
  for (const char* name : {"33369213973_9d9bb4cc96_c", "34085369442_304b6bafd9_c"}) {
    const std::vector<ListedTag> listed = listed_tags(folder / (std::string(name) + ".txt"));
    const std::vector<DetectedTag> tags =
        detect_tags(read_photo(folder / (std::string(name) + ".jpg")));
    int found = 0;
    double squares = 0;
    for (const ListedTag& expected : listed) {
      double nearest = 1e9;
      for (const DetectedTag& tag : tags) {
        if (tag.code != expected.code) continue;
        nearest = std::min(nearest, (tag.corners - expected.corners).squaredNorm() / 4);
      }
      if (nearest > 9) continue;
      ++found;
      squares += nearest;
    }
    fmt::print("{}: {} of {} codes ({} seen), corners within {:.3f} px RMS of the list\n", name,
               found, listed.size(), tags.size(), std::sqrt(squares / found));
    EXPECT_EQ(found, std::ssize(listed));
    EXPECT_EQ(tags.size(), listed.size());
    EXPECT_LT(std::sqrt(squares / found), 0.5);
  }
}

// They all show one code: as labels of clips they are refused.
TEST(RealCapture, TagsOfPhotographsAreNoLabelsOfClips) {
  const auto folder = measurement("apriltag_photos");
  SKIP_WITHOUT(folder);
  for (const auto& [name, times] :
       {std::pair("33369213973_9d9bb4cc96_c", 12), std::pair("34085369442_304b6bafd9_c", 25)}) {
    const TemporaryFolder written;
    const auto file = written.write(
        "d.yaml", fmt::format("pliant: dic/1\ntest: stretch-warp\npictures: {}/{}.jpg\n"
                              "labels: {{tag: 15 mm, edge: 15 mm}}\n"
                              "sample: {{width: 30 mm, height: 90 mm, mass: 1 g}}\n"
                              "clips: [{{name: lower, side: bottom, labels: [0]}},"
                              " {{name: upper, side: top, labels: [1]}}]\n",
                              folder.string(), name));
    const InputError error = input_error_of([&] { make_dic_session(read_dic(file), &read_photo); });
    fmt::print("{}\n", error.what());
    EXPECT_THAT(error.what(),
                testing::HasSubstr(fmt::format(
                    "shows the label 0 of the clip lower more than once (labels found: {})",
                    fmt::join(std::vector(static_cast<std::size_t>(times), 0), ", "))));
  }
}

}  // namespace
}  // namespace pliant::test
