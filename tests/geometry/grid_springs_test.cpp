#include "pliant/geometry/grid_springs.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

using testing::SizeIs;

class GridSpringsOf : public ::testing::TestWithParam<Diagonals> {
 protected:
  const TriangleMesh mesh = regular_grid(0.4, 0.6, 5, 4, GetParam());  // 0.1 x 0.2
  const GridSprings springs = grid_springs(mesh);

  Eigen::Vector2d way(const GridSpring& spring) const {
    return (mesh.positions.col(spring.vertices[1]) - mesh.positions.col(spring.vertices[0]))
        .head<2>()
        .cwiseAbs();
  }
};

TEST_P(GridSpringsOf, AreAsManyAsTheGridHasPairs) {
  EXPECT_THAT(springs.along_u, SizeIs(4 * 4));
  EXPECT_THAT(springs.along_v, SizeIs(5 * 3));
  EXPECT_THAT(springs.diagonal, SizeIs(2 * 4 * 3));
  EXPECT_THAT(springs.bending_u, SizeIs(3 * 4));
  EXPECT_THAT(springs.bending_v, SizeIs(5 * 2));
  EXPECT_THAT(springs.bending_diagonal, SizeIs(2 * 3 * 2));
}

TEST_P(GridSpringsOf, RunAlongTheirDirectionAtTheirRestLength) {
  const auto expect = [&](const std::vector<GridSpring>& family, double u, double v) {
    for (const GridSpring& spring : family) {
      EXPECT_TRUE(way(spring).isApprox(Eigen::Vector2d(u, v)));
      EXPECT_NEAR(spring.rest_length, std::hypot(u, v), 1e-12);
    }
  };
  expect(springs.along_u, 0.1, 0);
  expect(springs.along_v, 0, 0.2);
  expect(springs.diagonal, 0.1, 0.2);
  expect(springs.bending_u, 0.2, 0);
  expect(springs.bending_v, 0, 0.4);
  expect(springs.bending_diagonal, 0.2, 0.4);
}

TEST_P(GridSpringsOf, OfEachFamilyStandForTheWholeSheet) {
  for (const auto* family : {&springs.along_u, &springs.along_v, &springs.diagonal}) {
    double area = 0;
    for (const GridSpring& spring : *family) area += spring.area;
    EXPECT_NEAR(area, 0.4 * 0.6, 1e-12);
  }
}

std::string pattern_name(const ::testing::TestParamInfo<Diagonals>& pattern) {
  switch (pattern.param) {
    case Diagonals::alternating:
      return "Alternating";
    case Diagonals::rising:
      return "Rising";
    case Diagonals::falling:
      return "Falling";
  }
  return "";
}

INSTANTIATE_TEST_SUITE_P(Patterns, GridSpringsOf,
                         ::testing::Values(Diagonals::alternating, Diagonals::rising,
                                           Diagonals::falling),
                         pattern_name);

TEST(GridSprings, AreAtRestOnUnequalRectangles) {
  const TriangleMesh mesh = grid_of_lines({0, 0.05, 0.15, 0.25}, {0, 0.1, 0.4, 0.45});
  const GridSprings springs = grid_springs(mesh);
  for (const auto* family : {&springs.along_u, &springs.along_v, &springs.diagonal,
                             &springs.bending_u, &springs.bending_v, &springs.bending_diagonal}) {
    for (const GridSpring& spring : *family) {
      const auto [a, b] = spring.vertices;
      EXPECT_NEAR(spring.rest_length, (mesh.positions.col(b) - mesh.positions.col(a)).norm(),
                  1e-15);
    }
  }
}

TEST(GridSprings, NeedAGrid) {
  TriangleMesh mesh = regular_grid(0.1, 0.1, 3, 3);
  mesh.rest_corners.col(0) -= Eigen::Vector2d(0.01, 0.02);
  EXPECT_THROW(grid_springs(mesh), AssertionError);
}

}  // namespace
}  // namespace pliant
