#include "pliant/capture/seen_vertices.h"

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

TEST(VertexDeviations, AreThoseOfTheNearestPointAndGrowBeyondThem) {
  const TriangleMesh mesh = regular_grid(0.1, 0.1, 2, 2);  // its four corners
  Eigen::Matrix2Xd places(2, 2);
  places << 0.001, 0.099, 0.001, 0.099;
  Eigen::Matrix3Xd of_points(3, 2);
  of_points << 1e-6, 5e-6, 2e-6, 4e-6, 3e-6, 3e-6;
  Eigen::VectorXd leverages = Eigen::VectorXd::Constant(4, 0.2);
  leverages(0) = 4;
  const Eigen::Matrix3Xd found = vertex_deviations(mesh, places, of_points, leverages, 0.01);
  EXPECT_TRUE(found.col(0).isApprox(2 * of_points.col(0)));
  // Nothing is near the second: the largest along each axis.
  EXPECT_TRUE(found.col(1).isApprox(Eigen::Vector3d(5e-6, 4e-6, 3e-6)));
  EXPECT_TRUE(found.col(3).isApprox(of_points.col(1)));
}

}  // namespace
}  // namespace pliant
