#include "pliant/geometry/hinge_direction.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(HingeDirection, IsAcrossTheEdgeAndFoldedToTheFirstQuadrant) {
  EXPECT_EQ(curvature_angle({0, 2}), 0);             // parallel to v: bends weft
  EXPECT_EQ(curvature_angle({-3, 0}), kRightAngle);  // parallel to u: bends warp
  for (const Eigen::Vector2d& edge : {Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1),
                                      Eigen::Vector2d(1, -1), Eigen::Vector2d(-1, -1)}) {
    EXPECT_NEAR(curvature_angle(edge), kRightAngle / 2, 1e-15);
  }
}

TEST(HingeDirection, GivesEachHingeOfAGridOneComponent) {
  // Rectangles: the diagonals count as diagonal whatever their angle.
  const TriangleMesh mesh = regular_grid(0.3, 0.1, 4, 4);
  const std::vector<Hinge> hinges = find_hinges(mesh);
  const std::vector<BendingVector> weights = bending_weights(hinges, bending_rule(mesh));
  int counts[3] = {};
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Eigen::Vector2d edge = hinges[i].rest_edge;
    const int component = edge.x() == 0 ? 0 : (edge.y() == 0 ? 1 : 2);
    EXPECT_EQ(weights[i], BendingVector::Unit(component));
    ++counts[component];
  }
  EXPECT_EQ(counts[0], 6);
  EXPECT_EQ(counts[1], 6);
  EXPECT_EQ(counts[2], 9);
}

TEST(HingeDirection, IsInterpolatedOnOtherMeshes) {
  TriangleMesh mesh = regular_grid(0.3, 0.3, 4, 4);
  mesh.rest_corners.row(0) += 0.2 * mesh.rest_corners.row(1);
  EXPECT_EQ(bending_rule(mesh), BendingRule::interpolated);
  const std::vector<Hinge> hinges = find_hinges(mesh);
  const std::vector<BendingVector> weights = bending_weights(hinges, bending_rule(mesh));
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    EXPECT_EQ(weights[i], interpolated_weights(curvature_angle(hinges[i].rest_edge)));
  }
}

TEST(HingeDirection, InterpolationIsExactAtWeftWarpAnd45Degrees) {
  EXPECT_TRUE(interpolated_weights(0).isApprox(BendingVector::UnitX(), 1e-15));
  EXPECT_TRUE(interpolated_weights(kRightAngle).isApprox(BendingVector::UnitY(), 1e-15));
  EXPECT_TRUE(interpolated_weights(kRightAngle / 2).isApprox(BendingVector::UnitZ(), 1e-15));
}

TEST(HingeDirection, InterpolationIsASmoothPartitionWithoutNegativeParts) {
  constexpr int kSteps = 1000;
  BendingVector last = interpolated_weights(0);
  for (int i = 1; i <= kSteps; ++i) {
    const BendingVector weights = interpolated_weights(kRightAngle * i / kSteps);
    EXPECT_NEAR(weights.sum(), 1, 1e-15);
    EXPECT_GE(weights.minCoeff(), 0);
    // The steepest slope of cos^2 (2 angle) is 2.
    EXPECT_LE((weights - last).cwiseAbs().maxCoeff(), 2.001 * kRightAngle / kSteps);
    last = weights;
  }
}

TEST(HingeDirection, TreatsWeftAndWarpAlike) {
  for (const double angle : {0.1, 0.3, 0.7}) {
    const BendingVector weights = interpolated_weights(angle);
    const BendingVector mirrored = interpolated_weights(kRightAngle - angle);
    EXPECT_TRUE(mirrored.isApprox(BendingVector(weights(1), weights(0), weights(2)), 1e-14));
  }
}

}  // namespace
}  // namespace pliant
