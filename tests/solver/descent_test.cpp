#include "pliant/solver/descent.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/component_density.h"
#include "pliant/material/strain/spring.h"
#include "pliant/mechanics/element_potential.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

/// A sheet that hangs at two corners, each other point displaced at random.
struct ShakenSheet : test::ClothSheet {
  State state;
  Configuration start;

  explicit ShakenSheet(double size) : ClothSheet(regular_grid(0.1, 0.1, 5, 5), test::cotton()) {
    prescribe({20, 24});
    add_gravity();
    system.finish();
    state = system.initial_state();
    start = state.configuration;
    RandomStream random(5);
    for (int i = 0; i < system.points(); ++i) {
      if (!system.coordinates().is_free(i)) continue;
      for (int a = 0; a < 3; ++a) start.positions(a, i) += random.uniform(-size, size);
    }
  }

  Objective objective() const { return {system, {state}}; }
  Eigen::VectorXd no_guess() const {
    return Eigen::VectorXd::Zero(system.coordinates().unknowns());
  }
};

TEST(Descent, GoesDownFromWhereverItBegins) {
  for (const double size : {1e-5, 1e-3, 0.02}) {
    const ShakenSheet sheet(size);
    Workspace workspace(sheet.system);
    Configuration at = sheet.start;
    double energy = sheet.objective().energy(at).total();
    for (int i = 0; i < 10; ++i) {
      const DescentSummary summary =
          descend(sheet.objective(), {.iterations = 1}, sheet.no_guess(), workspace, at);
      EXPECT_TRUE(summary.converged);
      EXPECT_EQ(summary.start.total(), energy);
      const double now = sheet.objective().energy(at).total();
      EXPECT_LE(now, energy);
      energy = now;
    }
  }
}

/// A spring of 1 m that friction has held while it was stretched, now pulled a little less: the
/// slope of the friction is near 0 the way it came and 4 / tau the way it goes.
struct RelievedSpring {
  static constexpr double kStiffness = 100, kStrain = 0.1, kLess = 0.5;  // N/m, -, N
  static constexpr DahlParameters kFriction{2, 0, 0.001};
  System system;
  State state;

  RelievedSpring() : system(ends(), Eigen::Vector2d::Zero()) {
    Material material;
    material.components["spring"] = test::component(ScalarCurve::constant(kStiffness), kFriction);
    const auto law = std::make_shared<Sum>();
    add_component(material, "spring", 0, {}, *law);
    Stencils<Spring> stencils;
    stencils.add({0, 1}, {1}, 1);
    system.add(std::make_shared<ElementPotential<Spring>>(stencils, law));
    Eigen::Matrix3Xd pull = Eigen::Matrix3Xd::Zero(3, 2);
    pull(0, 1) = kStiffness * kStrain + kFriction.a - kLess;
    system.add(std::make_shared<PointForces>(pull));
    system.coordinates().prescribe(0);
    for (const int axis : {1, 2}) system.coordinates().prescribe_axis(1, axis);
    system.finish();
    state = system.initial_state();
    state.history.tail(kLanes).setConstant(kFriction.a);  // the friction stress
  }

  static Eigen::Matrix3Xd ends() {
    Eigen::Matrix3Xd ends = Eigen::Matrix3Xd::Zero(3, 2);
    ends(0, 1) = 1 + kStrain;
    return ends;
  }

  /// What one iteration adds to the energy from a little beyond where the state is.
  double rise(bool line_search) const {
    Workspace workspace(system);
    const Objective objective(system, {state});
    Configuration at = state.configuration;
    at.positions(0, 1) += 1e-9;
    const DescentOptions options{.iterations = 1, .line_search = line_search};
    const DescentSummary summary =
        descend(objective, options, Eigen::VectorXd::Zero(3), workspace, at);
    EXPECT_TRUE(summary.converged);
    return objective.energy(at).total() - summary.start.total();
  }
};

TEST(Descent, ShortensAChangeThatWouldGoUp) {
  EXPECT_GT(RelievedSpring().rise(false), 1e-3);
  EXPECT_LT(RelievedSpring().rise(true), 0);
}

TEST(Descent, EndsWithTheFirstIterationThatMovesNothingFurther) {
  const ShakenSheet sheet(1e-4);
  Workspace workspace(sheet.system);
  const auto iterations = [&](double motion) {
    Configuration at = sheet.start;
    return descend(sheet.objective(), {.iterations = 40, .motion = motion}, sheet.no_guess(),
                   workspace, at)
        .iterations;
  };
  EXPECT_EQ(iterations(1), 1);
  EXPECT_GT(iterations(1e-4), 1);
  EXPECT_LT(iterations(1e-4), 40);
  Configuration at = sheet.start;
  EXPECT_EQ(
      descend(sheet.objective(), {.motion = 1e-12}, sheet.no_guess(), workspace, at).iterations, 3);
}

TEST(Descent, RefusesForcesThatAreNotFinite) {
  const ShakenSheet sheet(1e-4);
  Workspace workspace(sheet.system);
  Configuration at = sheet.start;
  at.positions(0, 3) = NAN;
  EXPECT_FALSE(descend(sheet.objective(), {}, sheet.no_guess(), workspace, at).converged);
}

}  // namespace
}  // namespace pliant
