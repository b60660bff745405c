#include "pliant/capture/tag_edges.h"

#include <gtest/gtest.h>

#include "pliant/capture/tag_detector.h"

#include "capture/board_drawing.h"

namespace pliant {
namespace {

// A usual lens, and a board whose tags are 90 pixels wide.
CameraModel usual_lens() {
  CameraModel camera;
  camera.columns = 1280;
  camera.rows = 1024;
  camera.intrinsics << 2000, 2000, 640, 512, -0.12, 0.05, 0, 0, 0;
  return camera;
}

const TagBoard kWideTags{5, 4, 0.020, 0.005, 0};

/// How much larger the board seems than it is, by corners from the middle of the picture.
double magnification(const std::vector<DetectedTag>& tags, const RigidMotion& pose, bool by_lens) {
  const CameraModel camera = usual_lens();
  double missed = 0, squares = 0;
  for (const DetectedTag& tag : tags) {
    const TagCorners seen = by_lens ? tag.corners_by(camera) : tag.of_lines;
    const auto corners = kWideTags.corners(tag.code);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d known = *camera.project(pose * corners[static_cast<std::size_t>(i)]);
      const Eigen::Vector2d from_middle = known - Eigen::Vector2d(640, 512);
      missed += from_middle.dot(seen.col(i) - known);
      squares += from_middle.squaredNorm();
    }
  }
  return missed / squares;
}

TEST(TagEdges, OfTagsAreBentByAKnownLens) {
  const RigidMotion face{{3.141592653589793, 0, 0}, {0, 0, 0.45}};
  const RigidMotion to_middle{{0, 0, 0},
                              {-kWideTags.extent().x() / 2, -kWideTags.extent().y() / 2, 0}};
  const RigidMotion pose = face * to_middle;
  const std::vector<DetectedTag> tags =
      detect_tags(test::draw_board(usual_lens(), kWideTags, pose, 0.7));
  ASSERT_EQ(std::ssize(tags), kWideTags.tag_count());
  EXPECT_GT(magnification(tags, pose, false), 3e-5);
  EXPECT_LT(std::abs(magnification(tags, pose, true)), 1e-5);
}

}  // namespace
}  // namespace pliant
