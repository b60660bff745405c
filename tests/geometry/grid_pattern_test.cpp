#include "pliant/geometry/grid_pattern.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

std::optional<GridPattern> pattern_of(const TriangleMesh& mesh) {
  return grid_pattern(mesh, find_hinges(mesh));
}

TEST(GridPattern, OfAGridIsThatItWasMadeWith) {
  for (const Diagonals diagonals :
       {Diagonals::alternating, Diagonals::rising, Diagonals::falling}) {
    const auto pattern = pattern_of(regular_grid(0.3, 0.2, 4, 5, diagonals));
    ASSERT_TRUE(pattern);
    EXPECT_NEAR(pattern->side_u, 0.1, 1e-15);
    EXPECT_NEAR(pattern->side_v, 0.05, 1e-15);
    EXPECT_EQ(pattern->diagonals, diagonals);
  }
}

TEST(GridPattern, SurvivesTheRoundingOfFiles) {
  TriangleMesh mesh = regular_grid(0.1, 0.1, 4, 4);
  mesh.rest_corners = (mesh.rest_corners.array() * 1e5).round() / 1e5;  // five decimals
  EXPECT_TRUE(pattern_of(mesh));
}

TEST(GridPattern, IsNothingForASheetWhoseDiagonalsRunAtWill) {
  const TriangleMesh grid = regular_grid(1, 1, 4, 4, Diagonals::rising);
  TriangleMesh mesh = grid;
  // Turn the diagonal of the first square alone.
  mesh.triangles.col(0) << 0, 1, 4;
  mesh.triangles.col(1) << 1, 5, 4;
  mesh = flat_mesh(grid.positions.topRows<2>(), mesh.triangles);
  EXPECT_TRUE(is_cut_from_rectangles(mesh));
  EXPECT_FALSE(pattern_of(mesh));
}

TEST(GridPattern, IsNothingForUnequalRectangles) {
  TriangleMesh mesh = regular_grid(1, 1, 4, 4);
  mesh.rest_corners = mesh.rest_corners.cwiseProduct(mesh.rest_corners).eval();
  EXPECT_TRUE(is_cut_from_rectangles(mesh));
  EXPECT_FALSE(pattern_of(mesh));
}

TEST(GridPattern, IsNothingForTrianglesThatAreTurnedInTheRestPlane) {
  TriangleMesh mesh = regular_grid(1, 1, 4, 4);
  mesh.rest_corners.row(0) += 0.1 * mesh.rest_corners.row(1);
  EXPECT_FALSE(is_cut_from_rectangles(mesh));
  EXPECT_FALSE(pattern_of(mesh));
}

}  // namespace
}  // namespace pliant
