#include "pliant/solver/dynamic_relaxation.h"

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/mechanics/cord.h"
#include "pliant/solver/static_solver.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

constexpr double kTolerance = 1e-8;  // N

double distance(const Configuration& a, const Configuration& b) {
  return (a.positions - b.positions).colwise().norm().maxCoeff();
}

Configuration equilibrium_by_newton(const System& system, State state,
                                    const Controls& controls = kNoControls) {
  NewtonOptions options;
  options.tolerance = kTolerance;
  EXPECT_TRUE(StaticSolver(system, options).find_equilibrium(state, controls).converged);
  return state.configuration;
}

RelaxationSummary relax_to(double tolerance, const System& system, const State& state,
                           Configuration& at, const Controls& controls = kNoControls) {
  RelaxationOptions options;
  options.tolerance = tolerance;
  Hessian hessian = system.make_hessian();
  return relax(Objective(system, {.from = state, .controls = controls}), options, hessian, at);
}

/// A sheet that is held at two corners, its vertices moved by up to 2 mm.
struct HungSheet : ClothSheet {
  explicit HungSheet(const Material& material)
      : ClothSheet(regular_grid(0.1, 0.1, 6, 6), material) {
    prescribe({30, 35});
    add_gravity(-Eigen::Vector3d(0, 1, 0.3).normalized());
    system.finish();
  }

  State disturbed() const {
    State state = system.initial_state();
    RandomStream random(5);
    for (int i = 0; i < system.points(); ++i) {
      if (!system.coordinates().is_free(i)) continue;
      for (int a = 0; a < 3; ++a)
        state.configuration.positions(a, i) += random.uniform(-2e-3, 2e-3);
    }
    return state;
  }
};

TEST(DynamicRelaxation, FindsTheEquilibriumThatNewtonsMethodFinds) {
  const HungSheet sheet(test::linear_cloth(100, 30, 1e-3));
  const State state = sheet.disturbed();
  Configuration at = state.configuration;
  const RelaxationSummary summary = relax_to(kTolerance, sheet.system, state, at);
  EXPECT_TRUE(summary.converged);
  EXPECT_LT(summary.residual, kTolerance);
  EXPECT_GT(summary.peaks, 10);
  // The stiffness is assembled seldom: about once in 200 evaluations of the forces.
  EXPECT_LT(summary.mass_updates, 5 + summary.iterations / 150);
  const Configuration expected = equilibrium_by_newton(sheet.system, state);
  // The tolerance over the softest stiffness, that of bending: 1e-3 N m / (0.1 m)^2.
  EXPECT_LT(distance(at, expected), 1e-6);
  EXPECT_NEAR(summary.energy.total(), Objective(sheet.system, {state}).energy(expected).total(),
              1e-12);
}

TEST(DynamicRelaxation, SurvivesAClothThatStiffensOnTheWay) {
  // The masses are taken where the cloth is a thousand times softer than it becomes.
  Material material = test::linear_cloth(1, 1, 1e-3);
  material.components["stretch.warp"] = test::component(ScalarCurve::affine(1, 5000));
  ClothSheet sheet(regular_grid(0.05, 0.2, 3, 7), material);
  sheet.prescribe(sheet.row_at(0.2));
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, sheet.system.points());
  for (const int i : sheet.row_at(0)) forces(1, i) = -5;
  sheet.system.add(std::make_shared<PointForces>(forces));
  sheet.system.finish();
  const State state = sheet.system.initial_state();
  Configuration at = state.configuration;
  const RelaxationSummary summary = relax_to(kTolerance, sheet.system, state, at);
  EXPECT_TRUE(summary.converged);
  EXPECT_GT(summary.mass_updates, 1 + summary.iterations / 200);  // some were too small
  EXPECT_LT(distance(at, equilibrium_by_newton(sheet.system, state)), 1e-6);
}

TEST(DynamicRelaxation, FollowsAReversalOfFriction) {
  ClothSheet sheet(regular_grid(0.05, 0.2, 3, 7), test::cotton());
  const std::vector<int> low = sheet.row_at(0), high = sheet.row_at(0.2);
  sheet.prescribe(high);
  sheet.system.coordinates().add_clip(low, false);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(sheet.system.points());
  shares(low).setConstant(1.0 / static_cast<double>(low.size()));
  sheet.system.add(std::make_shared<PointForces>(0, shares));
  sheet.system.finish();
  Controls load;
  const auto pull = [&](double force) -> const Controls& {
    load.vectors = Eigen::Vector3d(0, -force, 0);
    return load;
  };

  State state = sheet.system.initial_state();
  NewtonOptions options;
  options.tolerance = kTolerance;
  StaticSolver solver(sheet.system, options);
  for (const double force : {0.5, 1.0, 1.5}) {
    ASSERT_TRUE(solver.find_equilibrium(state, pull(force)).converged);
    solver.accept(state);
  }
  Configuration at = state.configuration;
  EXPECT_TRUE(relax_to(kTolerance, sheet.system, state, at, pull(0.7)).converged);
  EXPECT_LT(distance(at, equilibrium_by_newton(sheet.system, state, pull(0.7))), 1e-7);
}

TEST(DynamicRelaxation, TurnsFreeClips) {
  ClothSheet sheet(regular_grid(0.04, 0.1, 5, 9), test::linear_cloth(100, 30, 1e-3));
  std::vector<int> clip = sheet.row_at(0);
  const std::vector<int> second = sheet.row_at(0.0125);
  clip.insert(clip.end(), second.begin(), second.end());
  sheet.prescribe(sheet.row_at(0.1));
  sheet.system.coordinates().add_clip(clip, false);
  sheet.system.add(
      std::make_shared<Cord>(clip.front(), 20, 0.05, Eigen::Vector3d(-0.02, -0.1, 0.05)));
  sheet.add_gravity();
  sheet.system.finish();
  const State state = sheet.system.initial_state();
  Configuration at = state.configuration;
  EXPECT_TRUE(relax_to(kTolerance, sheet.system, state, at).converged);
  const Configuration expected = equilibrium_by_newton(sheet.system, state);
  EXPECT_LT(distance(at, expected), 1e-6);
  EXPECT_GT(at.clips[0].rotation.angularDistance(Eigen::Quaterniond::Identity()), 0.1);
  EXPECT_LT(at.clips[0].rotation.angularDistance(expected.clips[0].rotation), 1e-5);
}

TEST(DynamicRelaxation, NotConvergingIsAResult) {
  const HungSheet sheet(test::linear_cloth(100, 30, 1e-3));
  const State state = sheet.disturbed();
  Configuration at = state.configuration;
  RelaxationOptions options;
  options.max_iterations = 25;
  Hessian hessian = sheet.system.make_hessian();
  const Objective objective(sheet.system, {state});
  const RelaxationSummary summary = relax(objective, options, hessian, at);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 25);
  EXPECT_DOUBLE_EQ(summary.residual,
                   largest_force(sheet.system.coordinates(), at, objective.gradient(at)));
  EXPECT_LT(summary.energy.total(), objective.energy(state.configuration).total());
}

TEST(DynamicRelaxation, StopsWhenAsked) {
  const HungSheet sheet(test::linear_cloth(100, 30, 1e-3));
  const State state = sheet.disturbed();
  Configuration at = state.configuration;
  StopFlag flag;
  flag.request();
  Hessian hessian = sheet.system.make_hessian();
  EXPECT_THROW(relax(Objective(sheet.system, {state}), {}, hessian, at, flag.token()), Interrupted);
}

}  // namespace
}  // namespace pliant
