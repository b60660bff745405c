#include "pliant/scene/obstacle_depth.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

const std::vector<ObstacleShape> kBodies{
    HalfSpace{{0.1, 0, -0.2}, Eigen::Vector3d(0.2, -0.1, 1).normalized()},
    Sphere{{0.05, -0.1, 0.2}, 0.2}, Capsule{{-0.1, 0, 0}, {0.2, 0.1, -0.1}, 0.05},
    Box{{0.05, 0, -0.1}, {0.2, 0.1, 0.15}}};

Eigen::Matrix3d random_corners(RandomStream& random) {
  return Eigen::Matrix3d::NullaryExpr([&] { return random.uniform(-0.6, 0.6); });
}

// No depth changes faster than its place.
TEST(ObstacleDepth, OfATriangleIsThatOfItsDeepestPlace) {
  constexpr int kParts = 60;
  RandomStream random(3);
  for (const ObstacleShape& body : kBodies) {
    int corners_outside = 0;
    for (int i = 0; i < 300; ++i) {
      const Eigen::Matrix3d corners = random_corners(random);
      double deepest = -INFINITY, longest = 0, of_corners = -INFINITY;
      for (int j = 0; j <= kParts; ++j) {
        for (int k = 0; j + k <= kParts; ++k) {
          const Eigen::Vector3d shares = Eigen::Vector3d(j, k, kParts - j - k) / kParts;
          deepest = std::max(deepest, depth_of_place(body, corners * shares));
        }
      }
      for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (corners.col(k) - corners.col((k + 1) % 3)).norm());
        of_corners = std::max(of_corners, depth_of_place(body, corners.col(k)));
      }
      const double depth = depth_of_triangle(body, corners);
      EXPECT_GE(depth, deepest - 1e-12) << body.index() << " " << i;
      EXPECT_LE(depth, deepest + longest / kParts) << body.index() << " " << i;
      corners_outside += depth > 0 && of_corners < 0 ? 1 : 0;
    }
    const bool is_plane = std::holds_alternative<HalfSpace>(body);
    EXPECT_EQ(corners_outside > 5, !is_plane) << body.index() << ": " << corners_outside;
  }
}

/// Level, at a height, around the z axis.
Eigen::Matrix3d level_triangle(double height) {
  Eigen::Matrix3d corners;
  corners << -1, 1, 0,  //
      -1, -1, 1,        //
      height, height, height;
  return corners;
}

TEST(ObstacleDepth, IsKnownInClosedForm) {
  const Box cube{{0, 0, 0}, {0.1, 0.1, 0.1}};
  EXPECT_NEAR(depth_of_triangle(cube, level_triangle(0.07)), 0.03, 1e-15);
  EXPECT_NEAR(depth_of_triangle(cube, level_triangle(0)), 0.1, 1e-15) << "all of its half sides";
  EXPECT_LT(depth_of_triangle(cube, level_triangle(0.1001)), 0);
  const Sphere ball{{0, 0, 0}, 0.1};
  EXPECT_NEAR(depth_of_triangle(ball, level_triangle(0.07)), 0.03, 1e-15);
  const Capsule upright{{0, 0, -1}, {0, 0, 1}, 1e-3}, level{{-2, 0, 0}, {2, 0, 0}, 0.1};
  EXPECT_NEAR(depth_of_triangle(upright, level_triangle(0)), 1e-3, 1e-15) << "its axis";
  EXPECT_NEAR(depth_of_triangle(level, level_triangle(0.07)), 0.03, 1e-15) << "beside its axis";
  EXPECT_LT(depth_of_triangle(level, level_triangle(0.1001)), 0);
}

// A triangle whose corners all lie far outside is cut by the edge of a box, and one beside it not.
TEST(ObstacleDepth, FindsTheCornerOfABox) {
  const Box cube{{0, 0, 0}, {1, 1, 1}};
  Eigen::Matrix3d across = 9 * Eigen::Matrix3d::Identity();  // x + y + z = 9
  EXPECT_LT(depth_of_triangle(cube, across), 0);
  across *= 0.3;  // x + y + z = 2.7
  for (int k = 0; k < 3; ++k) EXPECT_LT(depth_of_place(cube, across.col(k)), -1);
  EXPECT_NEAR(depth_of_triangle(cube, across), 0.1, 1e-15);
}

}  // namespace
}  // namespace pliant
