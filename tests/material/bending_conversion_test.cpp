#include "pliant/material/bending_conversion.h"

#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/regular_grid.h"

#include "support/irregular_sheet.h"

namespace pliant {
namespace {

constexpr double kSolved = 1e-6;  // of the iteration

BendingConversion convert(const TriangleMesh& mesh, const BendingVector& sheet) {
  return bending_conversion(mesh, find_hinges(mesh), sheet);
}

Eigen::Vector4d shown_by(const TriangleMesh& mesh, const BendingVector& hinges) {
  return sheet_stiffness(mesh, find_hinges(mesh), hinges);
}

TEST(BendingConversion, OfAlternatingSquaresIsFourThirdsAndTwoThirdsForAnIsotropicSheet) {
  // (3 - 1.5 / (1 + 2 r)) k = 3 and 3 r k (1 + 1 / (1 + 2 r)) = 3: r = 1/2, k = 4/3.
  const BendingConversion conversion = convert(regular_grid(0.1, 0.1, 25, 25), {1, 1, 1});
  EXPECT_TRUE(conversion.factors.isApprox(BendingVector(4.0 / 3, 4.0 / 3, 2.0 / 3), kSolved));
  EXPECT_LT(conversion.errors.norm(), kSolved);
}

TEST(BendingConversion, MeetsOrthotropicSheetsOnAlternatingDiagonals) {
  for (const BendingVector& sheet :
       {BendingVector(1, 2, 1.5), BendingVector(1, 2, 0.8), BendingVector(8, 1, 4)}) {
    const TriangleMesh mesh = regular_grid(0.2, 0.1, 41, 21);
    const BendingConversion conversion = convert(mesh, 1e-6 * sheet);
    const Eigen::Vector4d shown = shown_by(mesh, conversion.factors.cwiseProduct(sheet));
    const Eigen::Vector4d asked(sheet(0), sheet(1), sheet(2), sheet(2));
    EXPECT_LT(conversion.errors.norm(), kSolved);
    EXPECT_TRUE(shown.isApprox(asked, kSolved)) << shown;
  }
}

// Twice the sheet is twice the hinges: factors depend on ratios alone.
TEST(BendingConversion, FollowsTheRatiosOfTheSheet) {
  const BendingVector sheet(1, 2, 1.5);
  for (const TriangleMesh& mesh :
       {regular_grid(0.2, 0.1, 41, 21), test::irregular_sheet(20, 0.01, 3)}) {
    const BendingConverter converter(mesh, find_hinges(mesh));
    const Eigen::Matrix3d by_sheet = converter.factors_by_sheet(sheet);
    EXPECT_LT((by_sheet * sheet).norm(), 1e-3 * by_sheet.norm() * sheet.norm());
    const BendingVector change(0.02, 0.01, -0.02);
    const BendingVector moved =
        converter(sheet + change).factors - converter(sheet - change).factors;
    EXPECT_LT((moved - 2 * by_sheet * change).norm(), 0.01 * moved.norm());
  }
}

TEST(BendingConversion, LeavesSquaresOfOneDiagonalDirectionAsTheyAreAndSaysTheError) {
  const BendingVector sheet(1, 2, 1.5);
  const BendingConversion rising = convert(regular_grid(1, 1, 9, 9, Diagonals::rising), sheet);
  const BendingConversion falling = convert(regular_grid(1, 1, 9, 9, Diagonals::falling), sheet);
  const double excess = (1.0 + 2.0) / 1.5;  // (k_weft + k_warp) / k_diagonal
  EXPECT_TRUE(rising.factors.isOnes(kSolved));
  EXPECT_TRUE(rising.errors.isApprox(Eigen::Vector4d(0, 0, excess, 0), kSolved));
  EXPECT_TRUE(falling.factors.isOnes(kSolved));
  EXPECT_TRUE(falling.errors.isApprox(Eigen::Vector4d(0, 0, 0, excess), kSolved));
}

TEST(BendingConversion, MeetsAllButOneDirectionOnRectanglesOfOneDiagonalDirection) {
  const Eigen::Vector4d errors =
      convert(regular_grid(0.15, 0.1, 11, 11, Diagonals::rising), {1, 2, 1.5}).errors;
  EXPECT_LT(Eigen::Vector3d(errors(0), errors(1), errors(3)).norm(), kSolved);
}

// Lines that are moved to the edges of clips leave most cells nearly squares.
TEST(BendingConversion, OfAGridWithAFewUnequalLinesIsNearThatOfSquares) {
  std::vector<double> lines{0, 0.005, 0.01};
  for (int i = 1; i < 20; ++i) lines.push_back(0.01 + 0.08 * i / 19);
  lines.insert(lines.end(), {0.095, 0.1});
  const BendingVector sheet(1, 2, 1.5);
  const BendingConversion squares = convert(regular_grid(0.1, 0.1, 25, 25), sheet);
  const BendingConversion moved = convert(grid_of_lines(lines, lines), sheet);
  EXPECT_TRUE(moved.factors.isApprox(squares.factors, 0.03)) << moved.factors.transpose();
  EXPECT_LT(moved.errors.cwiseAbs().maxCoeff(), 0.03);
}

// Each direction within 4 %; the mean of the two at 45 degrees, which the mesh knows apart, better.
TEST(BendingConversion, MeetsIsotropicAndOrthotropicSheetsOnIrregularMeshes) {
  const TriangleMesh mesh = test::irregular_sheet(40, 0.01, 3);
  for (const BendingVector& sheet : {BendingVector(1, 1, 1), BendingVector(1, 2, 1.5),
                                     BendingVector(1, 2, 0.8), BendingVector(5, 1, 2.5)}) {
    const Eigen::Vector4d errors = convert(mesh, sheet).errors;
    EXPECT_LT(errors.lpNorm<Eigen::Infinity>(), 0.04) << errors;
    EXPECT_LT(std::abs(errors(kAlongRising) + errors(kAlongFalling)), 0.004) << errors;
  }
}

TEST(BendingConversion, ComesNearAndSaysTheErrorWhereNoHingesMakeTheSheet) {
  // Alternating diagonals need 2 k_diagonal > |k_weft - k_warp|.
  const BendingConversion conversion = convert(regular_grid(1, 1, 9, 9), {1, 33, 12});
  EXPECT_TRUE(conversion.factors.allFinite());
  EXPECT_GT(conversion.factors.minCoeff(), 0);
  EXPECT_GT(conversion.errors.norm(), 0.1);
  EXPECT_LT(conversion.errors.norm(), 0.3);  // and not any factors: the best there are
}

TEST(BendingConversion, IsTheSameForAllMultiplesOfASheet) {
  const TriangleMesh mesh = test::irregular_sheet(20, 0.01, 1);
  const BendingVector sheet(1, 2, 1.5);
  EXPECT_TRUE(convert(mesh, sheet).factors.isApprox(convert(mesh, 1e-6 * sheet).factors, kSolved));
}

TEST(BendingConversion, LeavesMeshesOfAFewTrianglesAsTheyAre) {
  TriangleMesh mesh = regular_grid(1, 1, 3, 3);
  for (Eigen::Index i = 0; i < mesh.rest_corners.cols(); ++i) {
    mesh.rest_corners(0, i) += 0.3 * mesh.rest_corners(1, i);  // no grid any more
  }
  EXPECT_EQ(convert(mesh, {1, 2, 3}).factors, BendingVector::Ones());
}

TEST(BendingConversion, TakesPanelsThatAreSewnTogether) {
  // The panels of an irregular sheet and of its copy, joined along one side in space only.
  const TriangleMesh panel = test::irregular_sheet(20, 0.01, 2);
  TriangleMesh sewn = panel;
  const Eigen::Index n = panel.vertex_count(), m = panel.triangle_count();
  sewn.triangles.conservativeResize(3, 2 * m);
  sewn.triangles.rightCols(m) = panel.triangles.array() + panel.vertex_count();
  for (Eigen::Index i = 0; i < 3 * m; ++i) {
    int& vertex = sewn.triangles(i % 3, m + i / 3);
    // The left side of one is the right side of the other.
    const int own = vertex - panel.vertex_count();
    if (own % 21 == 0) vertex = own + 20;
  }
  sewn.positions.conservativeResize(3, 2 * n);
  sewn.positions.rightCols(n) = panel.positions;
  sewn.rest_corners.conservativeResize(2, 6 * m);
  sewn.rest_corners.rightCols(3 * m) = panel.rest_corners;
  const BendingVector sheet(1, 2, 1.5);
  EXPECT_TRUE(convert(sewn, sheet).factors.isApprox(convert(panel, sheet).factors, kSolved));
}

TEST(BendingConversion, RefusesASheetWithoutStiffness) {
  EXPECT_THROW(convert(regular_grid(1, 1, 5, 5), {1, 0, 1}), AssertionError);
}

}  // namespace
}  // namespace pliant
