#include "pliant/material/plate_patch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/grid_bending.h"

#include "support/irregular_sheet.h"

namespace pliant {
namespace {

/// Rows of equilateral triangles, every other row shifted by half an edge.
TriangleMesh equilateral_sheet(int cells) {
  TriangleMesh mesh = regular_grid(cells, cells * std::sqrt(0.75), cells + 1, cells + 1);
  Eigen::Matrix2Xd vertices = mesh.positions.topRows<2>();
  for (int i = 0; i < vertices.cols(); ++i) {
    if (i / (cells + 1) % 2 == 1) vertices(0, i) += 0.5;
  }
  Eigen::Matrix3Xi triangles = mesh.triangles;
  test::make_delaunay(vertices, triangles);
  return flat_mesh(vertices, triangles);
}

Eigen::Vector4d stiffness(const TriangleMesh& mesh, const BendingVector& hinges) {
  return PlatePatch(mesh).rigidity(hinges) * hinges;
}

TEST(PlatePatch, OfARegularGridAgreesWithThePeriodicCell) {
  for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::rising}) {
    for (const BendingVector& hinges : {BendingVector(1, 1, 1), BendingVector(1, 2, 0.7)}) {
      const TriangleMesh mesh = regular_grid(0.4, 0.3, 41, 31, diagonals);
      const Eigen::Vector4d cell = grid_rigidity({0.01, 0.01, diagonals}, hinges) * hinges;
      const Eigen::Vector4d patch = stiffness(mesh, hinges);
      // Half a percent: what is left of the rim in the core.
      EXPECT_LT((patch.cwiseQuotient(cell).array() - 1).abs().maxCoeff(), 0.005) << patch;
    }
  }
}

// All vertices are alike and none moves; by symmetry the sheet is the same in all directions, and
// its stiffness is that of the hinges.
TEST(PlatePatch, OfEquilateralTrianglesAndEqualHingesHasTheirStiffnessInAllDirections) {
  const Eigen::Vector4d shown = stiffness(equilateral_sheet(30), {1, 1, 1});
  // The core's edge is no line of symmetry: an error of about one in its number of rows.
  EXPECT_LT((shown.array() - 1).abs().maxCoeff(), 0.03) << shown;
}

TEST(PlatePatch, OfIrregularTrianglesAndEqualHingesIsNearlyTheSameInAllDirections) {
  const Eigen::Vector4d shown = stiffness(test::irregular_sheet(40, 0.01, 1), {1, 1, 1});
  // A mesh without any direction shows 1.00 to 1.03; this one still knows a little of its grid.
  EXPECT_GT(shown.minCoeff(), 0.95) << shown;
  EXPECT_LT(shown.maxCoeff(), 1.1) << shown;
}

TEST(PlatePatch, DoesNotDependOnTheUnitsOfLengthAndStiffness) {
  const RigidityShares metres = PlatePatch(test::irregular_sheet(20, 1, 5)).rigidity({1, 2, 1.5});
  const RigidityShares millimetres =
      PlatePatch(test::irregular_sheet(20, 0.001, 5)).rigidity({1e-6, 2e-6, 1.5e-6});
  EXPECT_TRUE(metres.isApprox(millimetres, 1e-9));
}

TEST(PlatePatch, HasItsSharesAsDerivative) {
  PlatePatch patch(test::irregular_sheet(20, 0.01, 5));
  const BendingVector hinges(1, 2, 0.7);
  // Exact for the energy of the whole piece; in its core up to the work across the core's edge.
  const RigidityShares shares = patch.rigidity(hinges);
  constexpr double kStep = 1e-4;
  for (int j = 0; j < 3; ++j) {
    const BendingVector more = hinges + kStep * BendingVector::Unit(j);
    const BendingVector less = hinges - kStep * BendingVector::Unit(j);
    const Eigen::Vector4d slope =
        (patch.rigidity(more) * more - patch.rigidity(less) * less) / (2 * kStep);
    EXPECT_LT((slope - shares.col(j)).norm(), 0.05 * shares.norm());
  }
}

TEST(PlatePatch, TooSmallToRelaxIsTakenAsImposed) {
  const TriangleMesh mesh = regular_grid(0.03, 0.03, 4, 4, Diagonals::rising);
  const Eigen::Vector4d shown = stiffness(mesh, {1, 1, 1});
  EXPECT_TRUE(shown.allFinite());
  EXPECT_GT(shown.minCoeff(), 0);
}

TEST(PlatePatch, RefusesHingesWithoutStiffness) {
  PlatePatch patch(regular_grid(1, 1, 5, 5));
  EXPECT_THROW(patch.rigidity({1, 0, 1}), AssertionError);
}

}  // namespace
}  // namespace pliant
