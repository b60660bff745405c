#include "pliant/capture/tag_detector.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "capture/tag_drawing.h"
#include "capture/texture.h"

namespace pliant {
namespace {

using test::draw_tag;

// A side of 100 pixels turned by 17 degrees, its middle at (90.3, 84.8).
Eigen::Matrix<double, 2, 4> turned_square(double side) {
  const Eigen::Rotation2Dd turn(0.3);
  Eigen::Matrix<double, 2, 4> unit;
  unit << -1, 1, 1, -1, 1, 1, -1, -1;  // rows count downwards
  return ((turn.toRotationMatrix() * (side / 2) * unit).colwise() + Eigen::Vector2d(90.3, 84.8));
}

double corner_rms(const DetectedTag& tag, const Eigen::Matrix<double, 2, 4>& corners) {
  return std::sqrt((tag.corners - corners).squaredNorm() / 4);
}

TEST(TagDetector, KnowsCodeAndCornersOfADrawnTag) {
  for (const double side : {20.0, 30.0, 60.0, 100.0}) {
    for (const int code : {0, 17, 586}) {
      GreyPicture picture = draw_tag(180, 180, code, turned_square(side), 0.7);
      RandomStream random(5);
      test::add_noise(picture, 0.01, random);
      const std::vector<DetectedTag> tags = detect_tags(picture);
      ASSERT_EQ(tags.size(), 1u) << code;
      EXPECT_EQ(tags[0].code, code);
      // A pixel of noise 0.01 moves a place of an edge by some 0.03 pixels, and there are as many
      // places as pixels; in cells of 2.5 pixels the blur reaches from one edge to the next.
      RecordProperty(
          "side_" + std::to_string(static_cast<int>(side)) + "_code_" + std::to_string(code),
          std::to_string(corner_rms(tags[0], turned_square(side))));
      EXPECT_LT(corner_rms(tags[0], turned_square(side)), side < 30   ? 0.12
                                                          : side < 60 ? 0.04
                                                                      : 0.03)
          << code << " of side " << side;
    }
  }
}

TEST(TagDetector, TakesNoMirroredTag) {
  const GreyPicture picture = draw_tag(180, 180, 3, turned_square(100), 0.7);
  EXPECT_EQ(detect_tags(picture).size(), 1u);
  EXPECT_TRUE(detect_tags(picture.rowwise().reverse()).empty());
}

// Noise of speckles of one to seven pixels, as of cloth.
TEST(SlowTagDetector, SeesNoCodesInNoise) {
  for (int seed = 0; seed < 40; ++seed) {
    RandomStream random(seed);
    GreyPicture picture = GreyPicture::Zero(480, 640);
    test::add_noise(picture, 1, random);
    picture = test::blurred(picture, random.uniform(0.8, 3.3));
    picture = 0.5f + 0.2f * picture / std::sqrt(picture.square().mean());
    EXPECT_TRUE(detect_tags(picture).empty()) << seed;
  }
}

}  // namespace
}  // namespace pliant
