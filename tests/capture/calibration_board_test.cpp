#include "pliant/capture/calibration_board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/board_drawing.h"
#include "capture/texture.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

// A lens with a strong barrel distortion, 0.3 m from a tilted board of tags 28 pixels wide.
CameraModel wide_lens() {
  CameraModel camera;
  camera.columns = 640;
  camera.rows = 480;
  camera.intrinsics << 700, 702, 322, 238, -0.3, 0.1, 0.001, -0.0005, 0;
  return camera;
}

const TagBoard kBoard{8, 5, 0.012, 0.004, 20};

RigidMotion tilted_board() {
  const RigidMotion tilt{{0.3, -0.4, 0.1}, {0, 0, 0.3}};
  const RigidMotion face{{3.141592653589793, 0, 0}, {0, 0, 0}};
  const RigidMotion to_middle{{0, 0, 0}, {-kBoard.extent().x() / 2, -kBoard.extent().y() / 2, 0}};
  return tilt * face * to_middle;
}

const GreyPicture& noisy_picture() {
  static const GreyPicture kPicture = [] {
    GreyPicture picture = test::draw_board(wide_lens(), kBoard, tilted_board(), 0.7);
    RandomStream random(3);
    test::add_noise(picture, 0.01, random);
    return picture;
  }();
  return kPicture;
}

TEST(CalibrationBoard, IsFoundInAPictureToATenthOfAPixel) {
  const CalibrationBoard board{"board", kBoard};
  const PictureFindings found = find_boards(noisy_picture(), {board});
  ASSERT_EQ(found.boards.size(), 1u) << found.problem;
  const BoardView& view = found.boards[0];
  EXPECT_GE(view.corners.size(), 4 * 38u);
  const Eigen::Matrix3Xd corners = board.corners();
  const RigidMotion pose = tilted_board();
  const double count = static_cast<double>(view.pixels.cols());
  double squares = 0, worst = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < view.pixels.cols(); ++i) {
    const auto expected = wide_lens().project(pose * corners.col(view.corners[i]));
    const Eigen::Vector2d missed = view.pixels.col(i) - *expected;
    sum += missed;
    squares += missed.squaredNorm();
    worst = std::max(worst, missed.norm());
  }
  // Of both coordinates: noise of 0.01 leaves some 0.03 pixels of each.
  EXPECT_LT(std::sqrt(squares / count), 0.09);
  RecordProperty("rms_px", std::to_string(std::sqrt(squares / count)));
  RecordProperty("worst_px", std::to_string(worst));
  EXPECT_LT(worst, 0.3);
  EXPECT_LT((sum / count).norm(), 0.01);
}

TEST(CalibrationBoard, SaysWhyAPictureShowsNone) {
  const std::vector<CalibrationBoard> boards{{"board", kBoard}};
  const GreyPicture picture = noisy_picture();
  EXPECT_THAT(find_boards(GreyPicture::Constant(100, 100, 0.5f), boards).problem,
              HasSubstr("no board"));
  EXPECT_THAT(find_boards(picture.rowwise().reverse(), boards).problem, HasSubstr("mirrored"));
  EXPECT_THAT(find_boards(picture, {{"other", TagBoard{2, 2, 0.012, 0.004, 300}}}).problem,
              HasSubstr("tags of no board"));
}

TEST(CalibrationBoard, LeavesOutACodeThatIsSeenTwice) {
  GreyPicture twice(480, 1280);
  twice << noisy_picture(), noisy_picture();
  const PictureFindings found = find_boards(twice, {{"board", kBoard}});
  EXPECT_TRUE(found.boards.empty());
  EXPECT_THAT(found.problem, HasSubstr("twice"));
}

}  // namespace
}  // namespace pliant
