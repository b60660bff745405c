// A hinge that is folded further than half a turn.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/hinges.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/element_potential.h"

#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr double kHingeEdge = 0.02;  // m

/// One hinge along y whose second wing is turned up by `angle`.
Eigen::Matrix3Xd folded(double angle) {
  Eigen::Matrix3Xd x(3, 4);
  x.col(0) << 0, 0, 0;
  x.col(1) << 0, kHingeEdge, 0;
  x.col(2) << -kHingeEdge, kHingeEdge / 3, 0;
  x.col(3) << kHingeEdge * std::cos(angle), kHingeEdge / 2, kHingeEdge * std::sin(angle);
  return x;
}

TEST(HingePotential, FollowsAHingeThroughHalfATurnAndBack) {
  Stencils<DiscreteShells> stencils;
  stencils.add({0, 1, 2, 3}, {0, kHingeEdge, 0}, kHingeEdge * kHingeEdge / 3);
  auto law = std::make_shared<Sum>();
  law->add_addend(std::make_unique<StiffnessDensity>(0, ScalarCurve::constant(1)));
  const auto potential = std::make_shared<ElementPotential<DiscreteShells>>(
      stencils, law, std::vector<int>{}, std::vector<std::string>{"strain.bend"});
  System system(folded(0), Eigen::VectorXd::Ones(4));
  system.add(potential);
  system.finish();
  State state = system.initial_state();
  const double sign = dihedral_angle(DiscreteShells::Positions(folded(0.1))) > 0 ? 1 : -1;
  // Steps of a quarter of a turn away from flat at most, of three quarters towards and through it.
  for (const double angle : {0.9, 2.4, 3.3, 4.8, 2 * std::numbers::pi, 7.8, 3.2, 2.9, -1.7, -3.2,
                             -4.7, -6.2, -1.6, 3.0}) {
    const Configuration at{folded(angle), {}};
    const double strain = 3 * sign * angle / kHingeEdge;
    EXPECT_NEAR(test::energy_of(system, at, state).stored,
                kHingeEdge * kHingeEdge / 3 * strain * strain / 2, 1e-9)
        << angle;
    test::accept(system, state, at);
    EXPECT_NEAR(potential->field_values(system.history_of(*potential, state))(0, 0), strain, 1e-9)
        << angle;
  }
}

}  // namespace
}  // namespace pliant
