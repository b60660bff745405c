#include <cmath>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/material/component_density.h"
#include "pliant/material/strain/spring.h"
#include "pliant/mechanics/element_potential.h"
#include "pliant/solver/time_stepper.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

double kinetic_energy(const System& system, const State& state) {
  return state.velocities.colwise().squaredNorm().dot(system.masses()) / 2;
}

double stored_energy(const System& system, const State& state) {
  return Objective(system, state).energy(state.configuration).stored;
}

/// A sheet of cotton, let go from the horizontal at two corners.
struct DroppedSheet : ClothSheet {
  DroppedSheet() : ClothSheet(regular_grid(0.2, 0.2, 9, 9), test::cotton()) {
    prescribe({72, 80});
    add_gravity();
    system.finish();
  }
};

TEST(TimeStepEnergy, WithFrictionEnergyAndWorkNeverExceedTheStart) {
  const DroppedSheet sheet;
  TimeStepOptions options;
  options.step = 0.015;
  options.tolerance = 1e-6;
  TimeStepper stepper(sheet.system, options);
  State state = sheet.system.initial_state();
  const double start = stored_energy(sheet.system, state);
  double work = 0;
  for (int step = 0; step < 100; ++step) {
    const StepSummary summary = stepper.advance(state);
    ASSERT_TRUE(summary.converged) << step;
    work += summary.work;
    const double total =
        kinetic_energy(sheet.system, state) + stored_energy(sheet.system, state) + work;
    // The weight falls through some 0.1 m: 6e-3 J; a step's residual does far less work.
    EXPECT_LT(total, start + 1e-8) << step;
  }
  EXPECT_GT(work, 1e-5);  // friction has done its part
}

/// One spring of 1 m and 1 kg between a held and a moving point: k = 135.6 N/m, Dahl friction
/// as that of cotton ([T] Table 5.1). It begins stretched, without friction stress.
struct FrictionSpring {
  static constexpr double kStiffness = 135.6, kStrain = 0.1;
  System system;

  explicit FrictionSpring(FrictionForm form) : system(ends(), Eigen::Vector2d(0, 1)) {
    Material material;
    material.components["spring"] =
        test::component(ScalarCurve::constant(kStiffness), DahlParameters{2.22, 3.16, 0.006});
    const auto law = std::make_shared<Sum>();
    add_component(material, "spring", 0, {.friction_form = form}, *law);
    Stencils<Spring> stencils;
    stencils.add({0, 1}, {1}, 1);
    system.add(std::make_shared<ElementPotential<Spring>>(stencils, law));
    system.coordinates().prescribe(0);
    system.finish();
  }

  static Eigen::Matrix3Xd ends() {
    Eigen::Matrix3Xd ends = Eigen::Matrix3Xd::Zero(3, 2);
    ends(0, 1) = 1 + kStrain;
    return ends;
  }

  /// Elastic energy that is left one step after letting go.
  double energy_after_a_step(double periods) const {
    TimeStepOptions options;
    options.step = periods * 2 * M_PI / std::sqrt(kStiffness);
    options.tolerance = 1e-9;
    TimeStepper stepper(system, options);
    State state = system.initial_state();
    state.history.tail(kLanes).setZero();  // the potential's last numbers: the friction stress
    EXPECT_TRUE(stepper.advance(state).converged);
    const double strain = state.configuration.positions.col(1).norm() - 1;
    return kStiffness / 2 * strain * strain;
  }
};

TEST(TimeStepEnergy, AReleasedSpringTakesTheReversalOfFrictionInOneStepOnlyInVariationalForm) {
  constexpr double kPeriods = 9;
  EXPECT_NEAR(FrictionSpring::kStiffness / 2 * std::pow(FrictionSpring::kStrain, 2), 0.68, 0.005);
  // The published form supposes that the spring goes on stretching.
  EXPECT_NEAR(FrictionSpring(FrictionForm::linearized).energy_after_a_step(kPeriods), 0.39, 0.005);
  EXPECT_NEAR(FrictionSpring(FrictionForm::variational).energy_after_a_step(kPeriods), 0.02, 0.005);
}

}  // namespace
}  // namespace pliant
