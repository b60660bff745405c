#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/hinges.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/solver/static_path.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

constexpr double kLength = 0.08;
constexpr double kStiffness = 1e-5, kFriction = 2e-4, kTau = 12;  // N m, N, 1/m

Material creasing_cloth() {
  Material material = test::linear_cloth(100, 50, 0);
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] =
        test::component(ScalarCurve::constant(kStiffness), DahlParameters{kFriction, 0, kTau});
  }
  return material;
}

/// A strip, long in the weft direction.
TriangleMesh strip() { return regular_grid(kLength, 0.01, 33, 5); }

Eigen::Matrix3Xd on_cylinder(const Eigen::Matrix3Xd& flat, double curvature) {
  Eigen::Matrix3Xd bent = flat;
  for (int i = 0; i < flat.cols(); ++i) {
    const double angle = curvature * (flat(0, i) - kLength / 2);
    bent(0, i) = std::sin(angle) / curvature;
    bent(2, i) = (1 - std::cos(angle)) / curvature;
  }
  return bent;
}

/// Rolls a strip up to a curvature on a growing cylinder, all of it held.
State roll_up(double curvature) {
  ClothSheet sheet(strip(), creasing_cloth());
  for (int i = 0; i < sheet.system.points(); ++i) sheet.system.coordinates().prescribe(i);
  sheet.system.finish();
  StaticPathOptions options;
  options.schedule = [&](double time) {
    const Eigen::Matrix3Xd positions = on_cylinder(sheet.mesh.positions, time);
    Controls controls;
    for (int i = 0; i < sheet.system.points(); ++i) {
      controls.places.push_back({i, positions.col(i)});
    }
    return controls;
  };
  StaticPath path(sheet.system, options);
  constexpr int kSteps = 10;  // hinges follow less than half a turn a step
  for (int i = 1; i <= kSteps; ++i) path.step(curvature * i / kSteps);
  return path.state();
}

/// Lets a strip go that is held at the corners of one triangle in its middle, and gives the
/// curvatures across its transverse hinges.
std::vector<double> release(const State& rolled) {
  ClothSheet sheet(strip(), creasing_cloth());
  const Eigen::Vector3i middle = sheet.mesh.triangles.col(sheet.mesh.triangle_count() / 2);
  for (const int i : middle) sheet.system.coordinates().prescribe(i);
  sheet.system.finish();
  StaticPathOptions options;
  options.newton.tolerance = 1e-9;
  options.newton.max_iterations = 500;
  StaticPath path(sheet.system, options, rolled);
  path.step(rolled.time + 1);

  std::vector<double> curvatures;
  const Eigen::Matrix3Xd& x = path.state().configuration.positions;
  for (const Hinge& hinge : find_hinges(sheet.mesh)) {
    if (std::abs(hinge.rest_edge.x()) > 1e-9) continue;
    DiscreteShells::Positions at;
    for (int i = 0; i < 4; ++i) at.col(i) = x.col(hinge.vertices[static_cast<size_t>(i)]);
    curvatures.push_back(std::abs(dihedral_angle(at)) / hinge.height);
  }
  return curvatures;
}

TEST(PersistentCurvature, AStripReleasedFromSaturationKeepsAOverThreeK) {
  // Strain is three times the curvature ([T] 5.2.1). Unloading by 5.3 tau and more leaves 1 % of
  // the friction stress of loading behind ([T] 5.2.3).
  constexpr double kept = kFriction / (3 * kStiffness);
  constexpr double rolled = kept + 5.5 * kTau / 3;
  const std::vector<double> curvatures = release(roll_up(rolled));
  EXPECT_EQ(curvatures.size(), 31u * 4u);
  for (const double curvature : curvatures) EXPECT_NEAR(curvature, kept, 0.01 * kept);
}

TEST(PersistentCurvature, AStripReleasedBeforeFrictionHasTurnedAroundKeepsLess) {
  constexpr double saturated = kFriction / (3 * kStiffness);
  constexpr double rolled = saturated + kTau / 3;
  for (const double curvature : release(roll_up(rolled))) {
    EXPECT_LT(curvature, 0.9 * saturated);
    EXPECT_GT(curvature, 0.2 * saturated);
  }
}

}  // namespace
}  // namespace pliant
