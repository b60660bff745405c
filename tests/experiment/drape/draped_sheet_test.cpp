// What anybody can check of the drape test. Meshes are coarse: they hold for bending lengths above
// edge / 0.6, and their coefficients are right to some 2 %.

#include "pliant/experiment/drape/draped_sheet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/irregular_mesh.h"

#include "support/cloth_sheet.h"
#include "support/published_bending.h"

namespace pliant {
namespace {

/// Sheets bend alike in all directions.
Material bending_cloth(double density, const ScalarCurve& stiffness,
                       const std::optional<DahlParameters>& friction = {}) {
  Material material = test::linear_cloth(200, 40, 0);
  material.density = density;
  material.bending_of = "sheet";
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = test::component(stiffness, friction);
  }
  return material;
}

/// Of a bending length (m), without friction: M / width = 3 k curvature, c^3 = 3 k / weight.
Material cloth_of(double bending_length) {
  constexpr double kDensity = 0.2;
  const double weight = 9.80665 * kDensity;
  return bending_cloth(kDensity, ScalarCurve::constant(weight * std::pow(bending_length, 3) / 3));
}

/// Of [P] 4.3.
Material doublecloth(bool with_friction) {
  const test::PublishedBending found = test::published_bending()[1];
  std::optional<DahlParameters> friction;
  if (with_friction) friction = DahlParameters{found.a, found.b, found.tau};
  return bending_cloth(found.density, ScalarCurve::affine(found.k1, found.k2), friction);
}

DrapeSetup coarse(DrapeHistory history = DrapeHistory::lowered) {
  DrapeSetup setup;
  setup.edge = 0.016;
  setup.history = history;
  return setup;
}

DrapeFigures figures_of(const Material& material, const DrapeSetup& setup, int seed = 1) {
  return drape(material, setup, RandomStream(static_cast<std::uint64_t>(seed))).figures;
}

class DrapedSheetTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  }
};

using SlowDrapedSheet = DrapedSheetTest;

TEST_F(DrapedSheetTest, StaysFlatWhereItIsStiff) {
  const DrapeFigures figures = figures_of(cloth_of(0.3), coarse());
  EXPECT_GT(figures.coefficient, 0.9999);
  EXPECT_LE(figures.coefficient, 1 + 1e-5);  // of the sum over lines
  EXPECT_EQ(figures.nodes, 0);
}

TEST_F(SlowDrapedSheet, CoversLessTheShorterItsBendingLength) {
  double before = 1;
  for (const double length : {0.06, 0.035, 0.023}) {
    const DrapeFigures figures = figures_of(cloth_of(length), coarse());
    EXPECT_LT(figures.coefficient, before) << length;
    before = figures.coefficient;
  }
  EXPECT_LT(before, 0.78);
}

TEST_F(SlowDrapedSheet, CoversHardlyMoreThanTheDiscWhereItIsLimp) {
  double before = 1;
  for (const double length : {0.02, 0.013}) {
    DrapeSetup setup;
    setup.edge = 0.5 * length;
    const DrapeFigures figures = figures_of(cloth_of(length), setup);
    EXPECT_LT(figures.coefficient, before - 0.05) << length;
    before = figures.coefficient;
  }
  EXPECT_LT(before, 0.4);
}

TEST_F(SlowDrapedSheet, WarnsOfAMeshThatIsTooCoarseForItsFolds) {
  const DrapedSheet sheet = drape(cloth_of(0.015), coarse(), RandomStream(1));
  ASSERT_FALSE(sheet.warnings.empty());
  EXPECT_NE(sheet.warnings.front().find("too coarse"), std::string::npos) << sheet.warnings.front();
  EXPECT_TRUE(drape(cloth_of(0.03), coarse(), RandomStream(1)).warnings.empty());
}

TEST_F(DrapedSheetTest, FallsIntoFoldsWhereItIsLimpEnough) {
  EXPECT_EQ(figures_of(cloth_of(0.05), coarse()).nodes, 0);
  const DrapeFigures limp = figures_of(cloth_of(0.025), coarse());
  EXPECT_GE(limp.nodes, 4);
  EXPECT_GT(limp.amplitude, 0.003);
}

TEST_F(DrapedSheetTest, HangsBelowAndInsideOfItsFlatOutline) {
  const DrapedSheet sheet = drape(cloth_of(0.025), coarse(), RandomStream(1));
  EXPECT_EQ(sheet.crossings, 0);
  EXPECT_LT(sheet.shape.positions.row(2).maxCoeff(), 1e-3);
  const double lowest = sheet.shape.positions.row(2).minCoeff();
  EXPECT_LT(lowest, -0.03);
  EXPECT_GT(lowest, -0.062);  // the overhang, and its stretch
  EXPECT_LE(std::ranges::max(sheet.silhouette.radii), 0.1501);
}

// Folds of a coarse mesh are one or two fewer or more: each is a point or so. With the first hinges
// on the disc's rim, not half a triangle's height outside of it, the two differ by 6 %.
TEST_F(SlowDrapedSheet, HardlyDependsOnItsMesh) {
  DrapeSetup fine = coarse();
  fine.edge = 0.01;
  const Material material = cloth_of(0.027);
  EXPECT_NEAR(figures_of(material, coarse()).coefficient, figures_of(material, fine).coefficient,
              0.035);
}

TEST_F(SlowDrapedSheet, HardlyDependsOnTheDirectionOfItsMesh) {
  Material material = cloth_of(0.027);
  material.components["bend.warp"].stiffness =
      ScalarCurve::constant(2 * material.components["bend.weft"].stiffness->value(0));
  std::vector<double> coefficients;
  for (int seed = 1; seed <= 3; ++seed) {
    coefficients.push_back(figures_of(material, coarse(), seed).coefficient);
  }
  const auto [least, most] = std::ranges::minmax(coefficients);
  EXPECT_LT(most - least, 0.03);  // some have a node more
}

TEST_F(SlowDrapedSheet, ComesToTheSameShapeOnEveryWayWithoutFriction) {
  const auto hung = [](DrapeHistory history) {
    DrapeSetup setup = coarse(history);
    setup.edge = 0.0115;
    return figures_of(doublecloth(false), setup);
  };
  const DrapeFigures lowered = hung(DrapeHistory::lowered), pulled = hung(DrapeHistory::pulled);
  EXPECT_EQ(pulled.nodes, lowered.nodes);
  EXPECT_NEAR(pulled.coefficient, lowered.coefficient, 1e-4);  // forces of 1e-3 of weights are left
}

TEST_F(DrapedSheetTest, KeepsSomethingOfItsWayWithFriction) {
  const Material material = doublecloth(true);
  const DrapeFigures lowered = figures_of(material, coarse());
  const DrapeFigures pulled = figures_of(material, coarse(DrapeHistory::pulled));
  EXPECT_GT(lowered.coefficient, 0.9);
  EXPECT_LT(pulled.coefficient, 0.7);
  EXPECT_GT(pulled.nodes, lowered.nodes);
}

TEST_F(SlowDrapedSheet, IsTheSameForTheSameChanceOnAnyThreads) {
  const Material material = cloth_of(0.02);
  const DrapedSheet one = drape(material, coarse(), RandomStream(3));
  const DrapedSheet two = drape(material, coarse(), RandomStream(3), {.threads = 2});
  EXPECT_EQ(one.shape.positions, two.shape.positions);
}

}  // namespace
}  // namespace pliant
