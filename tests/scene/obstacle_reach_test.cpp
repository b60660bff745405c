#include "pliant/scene/obstacle_reach.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

/// Two faces of a square of 2 m around the z axis, at a height.
struct Square {
  Eigen::Matrix3Xd positions{3, 4};
  Eigen::Matrix3Xi faces{3, 2};

  explicit Square(double height) {
    positions << -1, 1, 1, -1,  //
        -1, -1, 1, 1,           //
        height, height, height, height;
    faces << 0, 0,  //
        1, 2,       //
        2, 3;
  }

  ObstacleReach into(const ObstacleShape& shape, const Pose& body = {}, int led = -1) const {
    return reach_into(shape, body, positions, faces, [&](int point) { return point == led; });
  }
};

TEST(ObstacleReach, TellsTheFaceThatAnObstacleStandsInBetweenItsVertices) {
  const ObstacleReach reach = Square(0).into(Sphere{{0.5, -0.5, 0.01}, 0.1});
  EXPECT_FALSE(reach.vertex);
  ASSERT_TRUE(reach.face);
  EXPECT_EQ(reach.face->number, 0);
  EXPECT_NEAR(reach.face->depth, 0.09, 1e-15);
}

TEST(ObstacleReach, LooksWhereTheObstacleIsLed) {
  const Sphere ball{{0, 0, 0}, 0.1};
  Pose body;
  body.translation = {-0.5, 0.5, 5.02};
  EXPECT_FALSE(Square(5).into(ball).face);
  const ObstacleReach reach = Square(5).into(ball, body);
  ASSERT_TRUE(reach.face);
  EXPECT_EQ(reach.face->number, 1);
  EXPECT_NEAR(reach.face->depth, 0.08, 1e-14);
}

TEST(ObstacleReach, LeavesOutWhatIsLed) {
  const Sphere ball{{1, -1, 0.02}, 0.1};
  const ObstacleReach reach = Square(0).into(ball);
  ASSERT_TRUE(reach.vertex);
  EXPECT_EQ(reach.vertex->number, 1);
  EXPECT_NEAR(reach.vertex->depth, 0.08, 1e-15);
  EXPECT_TRUE(reach.face);
  const ObstacleReach held = Square(0).into(ball, {}, 1);
  EXPECT_FALSE(held.vertex || held.face);
}

}  // namespace
}  // namespace pliant
