#include "pliant/material/density/linearized_dahl_friction.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pliant/material/density/dahl_friction.h"

#include "support/density_samples.h"

namespace pliant {
namespace {

using test::advance;
using test::LaneState;
using test::response_of;

const DahlParameters kPolyester{2.1, 5.41, 0.031};

/// Largest difference of the two forms' stresses over a path of triangles between 0.05 and 0.25 in
/// `steps` steps a leg.
/// @param legs  1 for loading alone
double largest_difference(int steps, int legs) {
  const DahlFriction variational(0, kPolyester);
  const LinearizedDahlFriction linearized(0, {kPolyester, kPolyester});
  LaneState exact(1, 1), approximate(1, 1);
  for (LaneState* state : {&exact, &approximate}) {
    state->strain.setConstant(0.05);
    state->last = state->strain;
    state->before = state->strain - 0.2 / steps;  // moving already
  }
  double largest = 0;
  for (int step = 1; step <= legs * steps; ++step) {
    const double way = 0.2 * ((step - 1) / steps % 2 == 0 ? 1 : -1) / steps;
    exact.strain += way;
    approximate.strain += way;
    largest = std::max(largest, std::abs(response_of(variational, exact).stress(0, 0) -
                                         response_of(linearized, approximate).stress(0, 0)));
    advance(variational, exact);
    advance(linearized, approximate);
    // Rounding of some thousand steps.
    EXPECT_NEAR(exact.history(0, 0), approximate.history(0, 0), 1e-12);
  }
  return largest;
}

TEST(LinearizedDahlFriction, IsTheVariationalFormToSecondOrderWhileTheDirectionLasts) {
  const double coarse = largest_difference(200, 1), fine = largest_difference(400, 1);
  EXPECT_LT(coarse, 0.01 * kPolyester.a);
  EXPECT_NEAR(coarse / fine, 4, 0.2);
}

TEST(LinearizedDahlFriction, IsTheVariationalFormToFirstOrderThroughReversals) {
  const double coarse = largest_difference(200, 4), fine = largest_difference(400, 4);
  EXPECT_LT(coarse, 0.2 * kPolyester.a);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
}

// [T] Eq. 5.9 by hand, for loading and unloading on both sides of zero.
TEST(LinearizedDahlFriction, IsTheLineOfTheThesis) {
  const double step = 0.004, stress = 0.7, way = 0.003;
  for (const double last : {0.2, -0.2}) {
    for (const double sign : {1.0, -1.0}) {
      LaneState state(1, 1);
      state.last.setConstant(last);
      state.before.setConstant(last - sign * step);
      state.strain.setConstant(last + way);
      state.history.setConstant(stress);
      const auto& [a, b, tau] = kPolyester;
      const double side = last < 0 ? -1 : 1;
      const double slope =
          (a + b * std::abs(last) - sign * stress + side * b * sign * step) / (tau + step);
      const Response response =
          response_of(LinearizedDahlFriction(0, {kPolyester, kPolyester}), state);
      EXPECT_NEAR(response.tangent(0, 0), slope, 1e-12);
      EXPECT_NEAR(response.stress(0, 0), stress + slope * way, 1e-13);
    }
  }
}

}  // namespace
}  // namespace pliant
