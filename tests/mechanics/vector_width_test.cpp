// Forces, stiffness and what friction remembers have the same bits whatever the width of the
// processor's vectors.

#include <gtest/gtest.h>

#include "pliant/math/simd.h"

#include "support/cloth_systems.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr double kSide = 0.02;  // m

/// What a cloth's elements give on the way to where it was shaken to.
struct Swept {
  Eigen::VectorXd energies, history;
  Eigen::Matrix3Xd gradient;
  Eigen::MatrixXd exact, convex;
};

// Friction sticks in some elements and slips in others, and turns around on the second way.
Swept swept(const System& system) {
  constexpr StepTime kStep{1 / 0.01, 1, 0};
  RandomStream random(5);
  State state = system.initial_state();
  const Eigen::Matrix3Xd start = state.configuration.positions;
  Swept all;
  all.energies.resize(3);
  for (double& energy : all.energies) {
    const Configuration at{test::shaken(start, random, 0.05 * kSide), {}};
    energy = test::energy_of(system, at, state, kStep).total();
    all.gradient = test::gradient_of(system, at, state, kStep);
    all.exact = test::hessian_of(system, at, state, kStep);
    all.convex = test::hessian_of(system, at, state, kStep, Curvature::convex);
    test::accept(system, state, at, kStep);
  }
  all.history = state.history;
  return all;
}

TEST(VectorWidth, DoesNotMatterForClothWithFriction) {
  const auto mesh = test::jittered_grid(7 * kSide, 5 * kSide, 8, 6, 3);
  test::ClothSystem cloth = test::cloth_system(mesh, test::uneven_cotton(), test::damped());
  cloth.system->finish();
  const Swept wide = swept(*cloth.system);
  const simd::Narrow narrow;
  const Swept on_two = swept(*cloth.system);
  EXPECT_EQ(wide.energies, on_two.energies);
  EXPECT_EQ(wide.gradient, on_two.gradient);
  EXPECT_EQ(wide.exact, on_two.exact);
  EXPECT_EQ(wide.convex, on_two.convex);
  EXPECT_EQ(wide.history, on_two.history);
  EXPECT_GT(wide.gradient.norm(), 0);
}

}  // namespace
}  // namespace pliant
