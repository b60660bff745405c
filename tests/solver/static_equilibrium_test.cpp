#include <cmath>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/mechanics/cord.h"
#include "pliant/solver/static_solver.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

Eigen::Vector3d sum_over(const Eigen::Matrix3Xd& columns, const std::vector<int>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int point : points) sum += columns.col(point);
  return sum;
}

TEST(StaticEquilibrium, AStretchedStripPullsWithTheForceOfItsMaterial) {
  constexpr double kWidth = 0.05, kLength = 0.2, kStretch = 1.1;
  ClothSheet sheet(regular_grid(kWidth, kLength, 4, 9), test::linear_cloth(100, 30, 1e-5));
  const std::vector<int> low = sheet.row_at(0), high = sheet.row_at(kLength);
  sheet.prescribe(low);
  sheet.prescribe(high);
  sheet.system.finish();

  State state = sheet.system.initial_state();
  Controls controls;
  controls.places = sheet.places(high);
  for (Controls::Place& place : controls.places) place.position.y() *= kStretch;
  NewtonOptions options;
  options.tolerance = 1e-11;
  StaticSolver solver(sheet.system, options);
  ASSERT_TRUE(solver.find_equilibrium(state, controls).converged);

  // Uniform stretch: StVK without coupling has no sideways stress.
  const double strain = (kStretch * kStretch - 1) / 2;
  const double expected = kWidth * 100 * strain * kStretch;
  const Eigen::Matrix3Xd forces = Objective(sheet.system, {state}).gradient(state.configuration);
  EXPECT_NEAR(sum_over(forces, high).y(), expected, 1e-9);  // points times tolerance
  EXPECT_NEAR(sum_over(forces, low).y(), -expected, 1e-9);
  for (int i = 0; i < sheet.system.points(); ++i) {
    // The tolerance over the stiffness of the mesh; rest positions are uniform.
    EXPECT_NEAR(state.configuration.positions(1, i), kStretch * sheet.mesh.positions(1, i), 1e-11);
  }
}

/// A strip whose upper edge is held and whose lower edge is in a free clip that two cords pull.
struct CordStrip : ClothSheet {
  std::vector<int> held = row_at(0.1), clip = row_at(0);
  std::vector<std::shared_ptr<Cord>> cords;

  CordStrip() : ClothSheet(regular_grid(0.04, 0.1, 5, 9), test::linear_cloth(100, 30, 1e-5)) {
    prescribe(held);
    system.coordinates().add_clip(clip, false);
    const Eigen::Vector3d ends[] = {{-0.02, -0.15, 0.05}, {0.05, -0.1, 0.02}};
    for (int i = 0; i < 2; ++i) {
      const int point = i == 0 ? clip.front() : clip.back();
      cords.push_back(std::make_shared<Cord>(point, 20, 0.08, ends[i]));
      system.add(cords.back());
    }
    add_gravity();
    system.finish();
  }
};

TEST(StaticEquilibrium, AFreeClipOnCordsIsInBalanceOfForceAndTorque) {
  const CordStrip strip;
  State state = strip.system.initial_state();
  NewtonOptions options;
  options.tolerance = 1e-10;
  StaticSolver solver(strip.system, options);
  ASSERT_TRUE(solver.find_equilibrium(state).converged);
  const Eigen::Matrix3Xd& x = state.configuration.positions;

  // All that acts on the strip from outside: what holds it, its weight and the cords.
  const Eigen::Matrix3Xd gradient = Objective(strip.system, {state}).gradient(state.configuration);
  Eigen::Matrix3Xd outside = strip.weight();
  for (const int i : strip.held) outside.col(i) += gradient.col(i);
  double pull = 0;
  for (const auto& cord : strip.cords) {
    outside.col(cord->point()) += cord->force(state.configuration);
    pull += cord->force(state.configuration).norm();
  }
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  for (int i = 0; i < x.cols(); ++i) torque += x.col(i).head<3>().cross(outside.col(i));
  EXPECT_GT(pull, 0.5);
  EXPECT_LT(outside.rowwise().sum().norm(), 1e-8);  // points times tolerance
  EXPECT_LT(torque.norm(), 1e-9);
  for (const int i : strip.clip) {
    for (const int j : strip.clip) {
      const double distance = (strip.mesh.positions.col(i) - strip.mesh.positions.col(j)).norm();
      EXPECT_NEAR((x.col(i) - x.col(j)).norm(), distance, 1e-14);
    }
  }
}

TEST(StaticEquilibrium, NotConvergingIsAResult) {
  const CordStrip strip;
  State state = strip.system.initial_state();
  NewtonOptions options;
  options.max_iterations = 2;
  const NewtonSummary summary = StaticSolver(strip.system, options).find_equilibrium(state);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 2);
  EXPECT_GT(summary.residual, options.tolerance);
}

TEST(StaticEquilibrium, ASheetMovedRigidlyByItsClampsFeelsNoForce) {
  ClothSheet sheet(regular_grid(0.1, 0.1, 5, 5), test::linear_cloth(100, 30, 1e-5));
  const int clips[] = {sheet.system.coordinates().add_clip(sheet.row_at(0), true),
                       sheet.system.coordinates().add_clip(sheet.row_at(0.1), true)};
  const Eigen::Vector3d places[] = {{0.05, 0, 0}, {0.05, 0.1, 0}};
  sheet.system.finish();

  State state = sheet.system.initial_state();
  NewtonOptions options;
  options.tolerance = 1e-10;
  StaticSolver solver(sheet.system, options);
  for (double time = 0.1; time < 1; time += 0.1) {
    const Pose motion{
        Eigen::Quaterniond(Eigen::AngleAxisd(2 * time, Eigen::Vector3d(1, 2, 2).normalized())),
        time * Eigen::Vector3d(0.3, -0.1, 0.2)};
    Controls controls;
    for (int k = 0; k < 2; ++k) {
      controls.poses.push_back({clips[k], {motion.rotation, motion.apply(places[k])}});
    }
    ASSERT_TRUE(solver.find_equilibrium(state, controls).converged) << time;
    solver.accept(state);
    for (int i = 0; i < sheet.system.points(); ++i) {
      const Eigen::Vector3d expected = motion.apply(sheet.mesh.positions.col(i));
      // Tolerance over bending stiffness, 1e-5 N m / (edge 25 mm)^2.
      EXPECT_LT((state.configuration.positions.col(i) - expected).norm(), 1e-7) << i;
    }
  }
}

}  // namespace
}  // namespace pliant
