// The conversion of bending stiffness where it is used: cloth in space with a stiff membrane,
// rolled to cylinders and relaxed, shows the bending stiffness of its material.

#include "solver/bent_sheet.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/geometry/hinge_direction.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/regular_grid.h"

#include "support/cloth_sheet.h"
#include "support/irregular_sheet.h"

namespace pliant {
namespace {

constexpr double kEdge = 0.004;      // m
constexpr double kCurvature = 2;     // 1/m: small beside 1 / edge
constexpr double kMembrane = 400;    // N/m, of a woven cloth
constexpr double kStiffness = 1e-6;  // N m
constexpr double kRightAngle = std::numbers::pi / 2;

const BendingVector kSheets[] = {{1, 1, 1}, {1, 2, 0.8}};

TriangleMesh square_grid(int cells, Diagonals diagonals) {
  return regular_grid(cells * kEdge, cells * kEdge, cells + 1, cells + 1, diagonals);
}

/// A material whose numbers are those of a sheet.
/// @param bending  of weft, warp and diagonal, over kStiffness
Material sheet_of(const BendingVector& bending) {
  Material material = test::linear_cloth(kMembrane, kMembrane, 0);
  material.bending_of = "sheet";
  const char* names[] = {"bend.weft", "bend.warp", "bend.diagonal"};
  for (int i = 0; i < 3; ++i) {
    material.components[names[i]] = test::component(ScalarCurve::constant(kStiffness * bending(i)));
  }
  return material;
}

/// What a mesh shows in a direction when it is to be a sheet, over kStiffness.
double shown(const TriangleMesh& mesh, const BendingVector& sheet, double direction) {
  return test::shown_stiffness(mesh, sheet_of(sheet), {kCurvature, direction}) / kStiffness;
}

void expect_sheet(const TriangleMesh& mesh, const BendingVector& sheet, double tolerance) {
  EXPECT_NEAR(shown(mesh, sheet, 0), sheet(0), tolerance * sheet(0));
  EXPECT_NEAR(shown(mesh, sheet, kRightAngle), sheet(1), tolerance * sheet(1));
  EXPECT_NEAR(shown(mesh, sheet, kRightAngle / 2), sheet(2), tolerance * sheet(2));
}

// The held rim cannot relax: an error of about 1 / cells. Without the conversion, or with its
// inverse, the isotropic sheet would be a sixth softer along weft and warp, and a third stiffer at
// 45 degrees, or more.
TEST(BentSheet, OfAFewSquaresShowsTheMaterialsStiffness) {
  const TriangleMesh mesh = square_grid(32, Diagonals::alternating);
  for (const BendingVector& sheet : kSheets) expect_sheet(mesh, sheet, 0.06);
}

TEST(BentSheet, OfAFewIrregularTrianglesShowsTheMaterialsStiffness) {
  expect_sheet(test::irregular_sheet(24, kEdge, 3), {1, 2, 0.8}, 0.06);
}

TEST(SlowBentSheet, OfAlternatingDiagonalsShowsTheSheetsStiffness) {
  const TriangleMesh mesh = square_grid(48, Diagonals::alternating);
  for (const BendingVector& sheet : kSheets) expect_sheet(mesh, sheet, 0.02);
}

TEST(SlowBentSheet, OfOneDiagonalDirectionShowsTheSheetsStiffnessAcrossItsDiagonals) {
  for (const Diagonals diagonals : {Diagonals::rising, Diagonals::falling}) {
    const TriangleMesh mesh = square_grid(16, diagonals);
    const double across = diagonals == Diagonals::rising ? -kRightAngle / 2 : kRightAngle / 2;
    for (const BendingVector& sheet : kSheets) {
      EXPECT_NEAR(shown(mesh, sheet, 0), sheet(0), 0.02 * sheet(0));
      EXPECT_NEAR(shown(mesh, sheet, kRightAngle), sheet(1), 0.02 * sheet(1));
      EXPECT_NEAR(shown(mesh, sheet, across), sheet(2), 0.02 * sheet(2));
      // And along them as much more as every such grid must (bending_conversion.h).
      const double along = sheet.sum();
      EXPECT_NEAR(shown(mesh, sheet, -across), along, 0.03 * along);
    }
  }
}

TEST(SlowBentSheet, OfIrregularTrianglesShowsTheSheetsStiffness) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "this build makes no irregular meshes";
  constexpr int kEdges = 36;  // a side; 4 %: a small mesh is not quite the same in all directions
  const TriangleMesh mesh = irregular_rectangle(kEdges * kEdge, kEdges * kEdge, kEdge);
  for (const BendingVector& sheet : kSheets) {
    expect_sheet(mesh, sheet, 0.04);
    EXPECT_NEAR(shown(mesh, sheet, -kRightAngle / 2), sheet(2), 0.04 * sheet(2));
  }
}

// What the conversion leaves out: vertices that move out of a cylinder stretch the membrane around
// them, and the sheet stiffens with membrane stiffness * curvature^2 * edge^4 / bending stiffness.
TEST(SlowBentSheet, StiffensWhereTheMembraneHindersTheRelaxation) {
  const TriangleMesh mesh = square_grid(24, Diagonals::alternating);
  const auto shown_at = [&](double ratio) {
    const double membrane = ratio * kStiffness / std::pow(kCurvature * kEdge * kEdge, 2);
    const Material hinges = test::linear_cloth(membrane, membrane, kStiffness);
    return test::shown_stiffness(mesh, hinges, {kCurvature, 0}) / kStiffness;
  };
  const double relaxed = 2.5 / 3, imposed = 1;
  EXPECT_NEAR(shown_at(1), relaxed, 0.01 * relaxed);
  EXPECT_NEAR(shown_at(100), relaxed, 0.04 * relaxed);
  EXPECT_GT(shown_at(1000), 1.1 * relaxed);
  EXPECT_NEAR(shown_at(1e4), imposed, 0.02);
}

}  // namespace
}  // namespace pliant
