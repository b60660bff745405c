#include "pliant/render/rest_lines.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

/// A triangle of 1 m legs whose rest shape is its shape, less a shift, with a line every 10 cm.
RestLinePattern pattern(const Eigen::Vector2d& shift = {0, 0}, float stretch = 1) {
  Eigen::Matrix3Xf positions(3, 3);
  positions << 0, stretch, 0, 0, 0, 1, 0, 0, 0;
  Eigen::Matrix3Xi triangles(3, 1);
  triangles << 0, 1, 2;
  RestLines lines{Eigen::Matrix2Xd(2, 3), 0.1};
  lines.rest_corners << 0, 1, 0, 0, 0, 1;
  lines.rest_corners.colwise() += shift;
  return {lines, positions, triangles};
}

RayHit at(float u, float v) { return {0, 0, {1 - u - v, u, v}, Eigen::Vector3f::UnitZ(), 1}; }

TEST(RestLines, RunAlongWarpAtMultiplesOfTheirSpacing) {
  for (const float v : {0.13F, 0.26F, 0.37F}) {
    EXPECT_TRUE(pattern().covers(at(0.3F, v), 0));
    EXPECT_FALSE(pattern().covers(at(0.34F, v), 0));
  }
}

TEST(RestLines, AlongWeftAreDashedFourTimesInASpacing) {
  for (const float u : {0.025F, 0.05F, 0.125F}) EXPECT_TRUE(pattern().covers(at(u, 0.4F), 0));
  for (const float u : {0.0375F, 0.0625F}) EXPECT_FALSE(pattern().covers(at(u, 0.4F), 0));
}

TEST(RestLines, BelongToRestCoordinatesHoweverFarFromTheirOrigin) {
  const Eigen::Vector2d far(1000.02, 0);
  EXPECT_TRUE(pattern(far).covers(at(0.28F, 0.13F), 0));
  EXPECT_FALSE(pattern(far).covers(at(0.3F, 0.13F), 0));
}

TEST(RestLines, StretchWithTheClothAndKeepTheWidthAskedForOnIt) {
  constexpr float kHalfWidth = 0.01F;  // m, where a spacing is 0.1 m, or 0.2 m when stretched
  EXPECT_TRUE(pattern().covers(at(0.309F, 0.13F), kHalfWidth));
  EXPECT_FALSE(pattern({0, 0}, 2).covers(at(0.309F, 0.13F), kHalfWidth));
  EXPECT_TRUE(pattern({0, 0}, 2).covers(at(0.3045F, 0.13F), kHalfWidth));
}

TEST(RestLines, VanishWhereTheyWouldCoverTheCloth) {
  EXPECT_FALSE(pattern().covers(at(0.3F, 0.4F), 0.03F));
}

TEST(RestLines, AreFiveToTwelveAcrossAClothAtARoundSpacing) {
  EXPECT_DOUBLE_EQ(usual_spacing(1.2 * 1.2), 0.1);
  EXPECT_DOUBLE_EQ(usual_spacing(1 * 0.8), 0.1);
  EXPECT_DOUBLE_EQ(usual_spacing(0.1 * 0.1), 0.01);
  EXPECT_DOUBLE_EQ(usual_spacing(0.4 * 0.4), 0.05);
}

}  // namespace
}  // namespace pliant
