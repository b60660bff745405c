#include "pliant/material/density/damping.h"

#include <gtest/gtest.h>

#include "support/density_samples.h"

namespace pliant {
namespace {

using test::LaneState;
using test::response_of;

LaneState moving() {
  LaneState state(2, 0);
  state.before.col(1).setConstant(0.10);
  state.last.col(1).setConstant(0.13);
  state.strain.col(1).setConstant(0.17);
  return state;
}

TEST(Damping, IsCoefficientTimesTheRateOfTheStep) {
  const double h = 0.002;
  const StepTime euler{1 / h, 1, 0}, bdf2{3 / (2 * h), 4.0 / 3, -1.0 / 3};
  const Damping law(1, 0.5);
  EXPECT_NEAR(response_of(law, moving(), euler).stress(0, 1), 0.5 * (0.17 - 0.13) / h, 1e-12);
  // Second order: (3 strain - 4 last + before) / (2 h).
  EXPECT_NEAR(response_of(law, moving(), bdf2).stress(0, 1),
              0.5 * (3 * 0.17 - 4 * 0.13 + 0.10) / (2 * h), 1e-11);
  EXPECT_EQ(response_of(law, moving(), euler).stress(0, 0), 0);
}

TEST(Damping, IsNothingInStatics) {
  const Damping law(1, 0.5);
  const Response response = response_of(law, moving());
  EXPECT_EQ(response.work(0), 0);
  EXPECT_EQ(response.stress.abs().maxCoeff(), 0);
  EXPECT_EQ(response.tangent.abs().maxCoeff(), 0);
}

TEST(Damping, TakesTheWorkOfItsStressOverTheStep) {
  const StepTime euler{1 / 0.002, 1, 0};
  const Damping law(1, 0.5);
  LaneState state = moving();
  const double stress = response_of(law, state, euler).stress(0, 1);
  EXPECT_NEAR(test::advance(law, state, euler)(0), stress * (0.17 - 0.13), 1e-13);
}

}  // namespace
}  // namespace pliant
