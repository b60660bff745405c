#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/solver/time_stepper.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

/// A soft sheet that swings from one edge: smooth motion of all strains.
struct SwingingSheet : ClothSheet {
  explicit SwingingSheet(double damping_fraction)
      : ClothSheet(regular_grid(0.1, 0.1, 3, 3), test::linear_cloth(20, 5, 1e-3),
                   {.damping_fraction = damping_fraction}) {
    prescribe(row_at(0.1));
    add_gravity();
    system.finish();
  }

  Eigen::Matrix3Xd swung(Integrator integrator, int steps) const {
    constexpr double kDuration = 0.08;  // s
    TimeStepOptions options;
    options.step = kDuration / steps;
    options.integrator = integrator;
    options.solve = StepSolve::converged;
    options.tolerance = 1e-11;
    TimeStepper stepper(system, options);
    State state = system.initial_state();
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.advance(state).converged);
    return state.configuration.positions;
  }
};

/// Orders between successive halvings of the step, from the differences of their results.
std::vector<double> orders(const SwingingSheet& sheet, Integrator integrator, int steps) {
  std::vector<double> differences;
  Eigen::Matrix3Xd coarse = sheet.swung(integrator, steps);
  for (int i = 0; i < 4; ++i) {
    steps *= 2;
    const Eigen::Matrix3Xd fine = sheet.swung(integrator, steps);
    differences.push_back((fine - coarse).norm());
    coarse = fine;
  }
  std::vector<double> found;
  for (size_t i = 1; i < differences.size(); ++i) {
    found.push_back(std::log2(differences[i - 1] / differences[i]));
  }
  return found;
}

class TimeStepOrder : public testing::TestWithParam<double> {};

TEST_P(TimeStepOrder, BackwardEulerIsOfOrderOne) {
  const SwingingSheet sheet(GetParam());
  for (const double order : orders(sheet, Integrator::backward_euler, 160)) {
    EXPECT_NEAR(order, 1, 0.1);  // the next term still shows at these steps
  }
}

TEST_P(TimeStepOrder, Bdf2IsOfOrderTwo) {
  const SwingingSheet sheet(GetParam());
  for (const double order : orders(sheet, Integrator::bdf2, 80)) EXPECT_NEAR(order, 2, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Damping, TimeStepOrder, testing::Values(0, 2e-3));

}  // namespace
}  // namespace pliant
