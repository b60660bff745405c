#include "pliant/geometry/rest_search.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"

#include "support/irregular_sheet.h"

namespace pliant {
namespace {

TEST(RestSearch, FindsEveryPointInItsTriangle) {
  const TriangleMesh mesh = test::irregular_sheet(12, 0.01, 3);
  const RestSearch search(mesh);
  RandomStream random(1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d point(random.uniform(0, 0.12), random.uniform(0, 0.12));
    const RestPoint found = search.find(point);
    EXPECT_EQ(found.outside, 0);
    EXPECT_GE(found.weights.minCoeff(), -1e-9);
    EXPECT_LT((mesh.rest_triangle(found.triangle) * found.weights - point).norm(), 1e-15);
  }
}

TEST(RestSearch, FindsVerticesAndPointsOnSides) {
  const TriangleMesh mesh = regular_grid(0.3, 0.1, 8, 5);
  const RestSearch search(mesh);
  for (const auto& vertex : mesh.positions.colwise()) {
    const RestPoint found = search.find(vertex.head<2>());
    EXPECT_EQ(found.outside, 0);
    EXPECT_NEAR(found.weights.maxCoeff(), 1, 1e-9);
  }
}

TEST(RestSearch, TakesTheNearestTriangleOfAPointOutside) {
  const TriangleMesh mesh = regular_grid(4, 4, 5, 5);
  const RestSearch search(mesh);
  const RestPoint found = search.find({4.5, 1.25});
  EXPECT_DOUBLE_EQ(found.outside, 0.5);
  EXPECT_LT(found.weights.minCoeff(), 0);
  const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(found.triangle);
  EXPECT_LT((corners * found.weights - Eigen::Vector2d(4.5, 1.25)).norm(), 1e-14);
  EXPECT_DOUBLE_EQ(corners.row(0).maxCoeff(), 4);
}

TEST(RestSearch, FindsTheRimOfAHole) {
  TriangleMesh mesh = regular_grid(4, 4, 5, 5);
  // Without the square between 1 and 2, both ways.
  Eigen::Matrix3Xi triangles(3, mesh.triangle_count() - 2);
  triangles << mesh.triangles.leftCols<10>(), mesh.triangles.rightCols<20>();
  mesh = flat_mesh(mesh.positions.topRows<2>(), triangles);
  EXPECT_DOUBLE_EQ(RestSearch(mesh).find({1.5, 1.75}).outside, 0.25);
}

TEST(Interpolated, IsExactForLinearValues) {
  const TriangleMesh mesh = test::irregular_sheet(6, 0.02, 9);
  const RestSearch search(mesh);
  const Eigen::Matrix3Xd values = 3 * mesh.positions;
  const std::vector<RestPoint> points{search.find({0.011, 0.093}), search.find({0.121, 0.05})};
  const Eigen::Matrix3Xd found = interpolated(mesh, points, values);
  EXPECT_LT((found.col(0) - Eigen::Vector3d(0.033, 0.279, 0)).norm(), 1e-14);
  EXPECT_LT((found.col(1) - Eigen::Vector3d(0.363, 0.15, 0)).norm(), 1e-14) << "beyond the rim";
}

}  // namespace
}  // namespace pliant
