// What a scene says of time, friction, damping and air reaches the steps.

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/scene/simulation.h"

#include "support/scene_simulation.h"

namespace pliant {
namespace {

using test::ClampedStrip;
using test::simulation_of;
using test::take_steps;
using test::way;

constexpr double kStep = 0.02;      // s, of the scenes here
constexpr double kGravity = 50;     // m/s^2, along +y: it stretches a strip by a third
constexpr double kResidual = 1e-9;  // N: ten times the tolerance of the steps

/// `time` of a scene, with further keys, each after a comma.
std::string steps(const std::string& more) {
  return "time: {step: 20 ms, duration: 1 s" + more + "}\n";
}

std::string converged(const std::string& more = "") { return steps(", tolerance: 1e-10 N" + more); }

/// A strip that gravity pulls from its rest length.
Simulation pulled_strip(const std::string& time, const Material& material) {
  return simulation_of(ClampedStrip::scene(time + "gravity: [0, 50, 0]\n"), material);
}

/// Forces on the clip that a step of backward Euler leaves, given three lengths, each a step apart.
/// @param stress  of the strip, at the end of the step (N/m)
double residual(double before, double last, double now, double stress) {
  const double acceleration = (now - 2 * last + before) / (kStep * kStep);
  return ClampedStrip::kMovingMass * (acceleration - kGravity) + ClampedStrip::pull(now, stress);
}

/// A free sheet of 0.2 kg/m^2, 100 mm wide and high.
std::string free_sheet(const std::string& more, const std::string& cloth = "") {
  return "pliant: scene/1\n"
         "cloth:\n"
         "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 2x2}, material: cloth.json" +
         cloth + "}\n" + more;
}

TEST(SceneStepping, TheIntegratorIsTheOneNamed) {
  const double unit = 10 * kStep * kStep;
  const auto fallen = [](const std::string& integrator) {
    Simulation simulation = simulation_of(
        free_sheet("gravity: [0, 0, -10]\n" + converged(integrator)), ClampedStrip::material());
    take_steps(simulation, 2);
    EXPECT_LT(way(simulation).topRows<2>().norm(), 1e-9);
    return Eigen::VectorXd(-way(simulation).row(2));
  };
  // Backward Euler falls by 1 and 2 units; BDF2 begins with it, then its speed is
  // (4 / 3 + 2 / 3) and its place 4 / 3 + 2 / 3 * 2.
  // The tolerance over the mass of a point.
  EXPECT_LT((fallen(", integrator: bdf2").array() - 8.0 / 3 * unit).abs().maxCoeff(), 1e-9);
  EXPECT_LT((fallen(", integrator: backward-euler").array() - 3 * unit).abs().maxCoeff(), 1e-9);
  EXPECT_LT((fallen("").array() - 3 * unit).abs().maxCoeff(), 1e-9);
}

TEST(SceneStepping, AConvergedStepBalancesAllForcesAtItsEnd) {
  for (const char* solve : {"", ", solve: converged"}) {
    Simulation strip = pulled_strip(converged(solve), ClampedStrip::material());
    take_steps(strip, 1);
    const double length = ClampedStrip::length(strip), rest = ClampedStrip::kLength;
    EXPECT_GT(length, 1.1 * rest);
    const double stress = ClampedStrip::kStiffness * ClampedStrip::strain(length);
    EXPECT_NEAR(residual(rest, rest, length, stress), 0, kResidual);
  }
}

TEST(SceneStepping, ALinearizedStepKnowsTheStiffnessAtItsStartAlone) {
  Simulation strip =
      pulled_strip(steps(", solve: linearized, linear_tolerance: 1e-12"), ClampedStrip::material());
  take_steps(strip, 1);
  const double inertia = ClampedStrip::kMovingMass / (kStep * kStep);
  const double stiffness = ClampedStrip::kWidth * ClampedStrip::kStiffness / ClampedStrip::kLength;
  EXPECT_NEAR(ClampedStrip::length(strip) - ClampedStrip::kLength,
              ClampedStrip::kMovingMass * kGravity / (inertia + stiffness), 1e-12);
}

TEST(SceneStepping, TheLinearToleranceDecidesHowLongAStepIsSolved) {
  const auto iterations = [](const std::string& tolerance) {
    const std::string scene =
        "pliant: scene/1\n"
        "cloth: [{name: sheet, mesh: {grid: 1 m x 1 m, nodes: 6x6}, material: cloth.json}]\n"
        "pins: [{cloth: sheet, corners: [top-left]}]\n"
        "gravity: [1, -10, 0]\n";
    Simulation sheet =
        simulation_of(scene + steps(", solve: linearized" + tolerance), ClampedStrip::material());
    take_steps(sheet, 1);
    return sheet.now().records.linear_iterations.front();
  };
  EXPECT_LT(iterations(", linear_tolerance: 0.5"), iterations(", linear_tolerance: 1e-3"));
  EXPECT_LT(iterations(", linear_tolerance: 1e-3"), iterations(", linear_tolerance: 1e-10"));
  EXPECT_EQ(iterations(""), iterations(", linear_tolerance: 1e-4"));
}

TEST(SceneStepping, AnIteratedStepStopsNearerToRestWhereItsMeshIsFineOrSomethingIsMet) {
  const auto tolerance = [](const std::string& size, const std::string& more = "") {
    const Simulation sheet = simulation_of(
        "pliant: scene/1\n"
        "cloth: [{name: sheet, mesh: {grid: " +
            size +
            ", nodes: 11x11}, material: cloth.json}]\n"
            "pins: [{cloth: sheet, corners: [top-left]}]\n" +
            more + "time: {step: 5 ms, duration: 50 ms}\n",
        ClampedStrip::material());
    return sheet.scene().time.motion_tolerance.value();
  };
  EXPECT_DOUBLE_EQ(tolerance("1 m x 1 m"), 3e-5);
  // Of the triangles' sides two thirds are as long as the squares', the others are diagonals.
  EXPECT_NEAR(tolerance("20 mm x 20 mm"), 2e-3 * (2 + std::sqrt(2)) / 3 / 300, 1e-7);
  const double of_fall = 0.01 * 9.80665 * 5e-3 * 5e-3;
  EXPECT_DOUBLE_EQ(tolerance("1 m x 1 m", "contact: {friction: 0.3}\n"), of_fall);
  EXPECT_DOUBLE_EQ(
      tolerance("1 m x 1 m",
                "obstacles: [{name: floor, plane: {point: [0, 0, -1], normal: [0, 0, 1]}}]\n"),
      of_fall);
}

TEST(SceneStepping, TheToleranceIsTheForceThatAStepMayLeave) {
  const auto iterations = [](const std::string& tolerance) {
    Simulation strip = pulled_strip(steps(", tolerance: " + tolerance), ClampedStrip::material());
    take_steps(strip, 1);
    return strip.now().records.newton_iterations.front();
  };
  EXPECT_EQ(iterations("1 N"), 0);  // the strip weighs 0.52 N here
  EXPECT_GT(iterations("0.1 N"), 0);
  EXPECT_GT(iterations("1e-9 N"), iterations("0.1 N"));
}

/// Friction on the stretch of the strip, saturated within a step of the scenes here.
constexpr DahlParameters kFriction{2, 1, 0.02};

Material rubbing_cloth() {
  Material material = ClampedStrip::material();
  material.components["stretch.warp"] =
      test::component(ScalarCurve::constant(ClampedStrip::kStiffness), kFriction);
  return material;
}

/// The solution of [T] Eq. 5.2 for a strain that grows from 0.
double friction_of_growing(double strain) {
  const auto [a, b, tau] = kFriction;
  return a + b * (strain - tau) + (b * tau - a) * std::exp(-strain / tau);
}

struct TwoSteps {
  double rest = ClampedStrip::kLength, first = 0, second = 0;  // lengths, m

  explicit TwoSteps(const std::string& friction) {
    Simulation strip = pulled_strip(converged(friction), rubbing_cloth());
    take_steps(strip, 1);
    first = ClampedStrip::length(strip);
    take_steps(strip, 1);
    second = ClampedStrip::length(strip);
    EXPECT_GT(second, first + 0.1 * rest);
  }

  /// With the friction stress at the end of each step (N/m).
  void expect_stress(double first_friction, double second_friction) const {
    const auto stress = [](double length, double friction) {
      return ClampedStrip::kStiffness * ClampedStrip::strain(length) + friction;
    };
    EXPECT_NEAR(residual(rest, rest, first, stress(first, first_friction)), 0, kResidual);
    EXPECT_NEAR(residual(rest, first, second, stress(second, second_friction)), 0, kResidual);
  }
};

TEST(SceneStepping, VariationalFrictionIsTheExactSolution) {
  for (const char* friction : {"", ", friction: variational"}) {
    const TwoSteps steps(friction);
    steps.expect_stress(friction_of_growing(ClampedStrip::strain(steps.first)),
                        friction_of_growing(ClampedStrip::strain(steps.second)));
  }
}

// [T] Eq. 5.9: the stress goes on from the last one with the slope (sigma_max - sigma + b d) /
// (tau + d), d being the last increment of strain; the last stress is exact (Eq. 5.2).
TEST(SceneStepping, LinearizedFrictionGoesOnWithTheSlopeAtTheStartOfTheStep) {
  const auto [a, b, tau] = kFriction;
  const TwoSteps steps(", friction: linearized");
  const double strain = ClampedStrip::strain(steps.first);
  const double increment = ClampedStrip::strain(steps.second) - strain;
  const double last = friction_of_growing(strain);
  const double slope = (a + b * strain - last + b * strain) / (tau + strain);
  steps.expect_stress(a / tau * strain, last + slope * increment);
}

TEST(SceneStepping, FrictionNoneLeavesElasticityAlone) {
  TwoSteps(", friction: none").expect_stress(0, 0);
}

/// Checks a step in which a strip is thrown out of rest and its damping takes a part of the speed.
/// @param fraction  of the stiffness at unit strain, times 1 s
void expect_damped(double fraction, const std::string& damping, const Material& material) {
  Simulation strip =
      simulation_of(ClampedStrip::scene(converged() + damping + "gravity: [0, 0, 0]\n", "",
                                        ", velocity: [0, 1, 0]"),
                    material);
  take_steps(strip, 1);
  const double length = ClampedStrip::length(strip), strain = ClampedStrip::strain(length);
  const double stress = ClampedStrip::kStiffness * (strain + fraction * strain / kStep);
  const double change = (length - ClampedStrip::kLength) / kStep - 1;  // of the speed
  EXPECT_NEAR(ClampedStrip::kMovingMass * change / kStep + ClampedStrip::pull(length, stress), 0,
              kResidual);
  const double area = ClampedStrip::kWidth * ClampedStrip::kLength;
  EXPECT_NEAR(strip.now().work,
              area * ClampedStrip::kStiffness * fraction * strain * strain / kStep, 1e-12);
}

TEST(SceneStepping, DampingIsAFractionOfTheStiffnessTimesTheRateOfStrain) {
  Material damped = ClampedStrip::material();
  damped.damping_fraction = 0.01;
  expect_damped(0, "", ClampedStrip::material());
  expect_damped(0.01, "", damped);
}

TEST(SceneStepping, DampingOfTheSceneTakesThePlaceOfTheMaterials) {
  Material damped = ClampedStrip::material();
  damped.damping_fraction = 0.01;
  expect_damped(0.03, "damping: {fraction: 0.03}\n", damped);
  expect_damped(0.03, "damping: {fraction: 0.03}\n", ClampedStrip::material());
  expect_damped(0, "damping: {fraction: 0}\n", damped);
}

// A small oscillation decays as exp(-fraction stiffness area / (2 mass length^2) t).
TEST(SceneStepping, DampingLetsAnOscillationDecay) {
  constexpr double kFraction = 1e-3, kSpeed = 1e-3;
  Simulation strip = simulation_of(
      ClampedStrip::scene(
          "gravity: [0, 0, 0]\ndamping: {fraction: 1e-3}\n"
          "time: {step: 0.5 ms, duration: 400 ms, integrator: bdf2, tolerance: 1e-8 N}\n",
          "", ", velocity: [0, 1e-3, 0]"),
      ClampedStrip::material());
  const double spring = ClampedStrip::kStiffness * ClampedStrip::kWidth / ClampedStrip::kLength;
  const double decay = kFraction * spring / (2 * ClampedStrip::kMovingMass);
  const double frequency = std::sqrt(spring / ClampedStrip::kMovingMass - decay * decay);
  double largest_error = 0;
  while (!strip.is_finished()) {
    strip.advance();
    const double time = strip.now().state.time;
    const double expected =
        kSpeed / frequency * std::exp(-decay * time) * std::sin(frequency * time);
    largest_error = std::max(
        largest_error, std::abs(ClampedStrip::length(strip) - ClampedStrip::kLength - expected));
  }
  EXPECT_LT(std::exp(-decay * 0.4), 0.8);
  // The first step, of backward Euler, delays it by half a step: 0.9 % of a radian.
  EXPECT_LT(largest_error, 0.02 * kSpeed / frequency);
}

TEST(SceneStepping, AirLetsASheetFallAtItsTerminalVelocityAgainstTheWind) {
  Simulation sheet =
      simulation_of(free_sheet("gravity: [0, 0, -10]\n"
                               "air: {drag: 1.5, density: 1.3 kg/m^3, wind: [3, 0, 2]}\n"
                               "time: {step: 50 ms, duration: 5 s, tolerance: 1e-11 N}\n"),
                    ClampedStrip::material());
  take_steps(sheet, 100);
  const double against_air = std::sqrt(2 * ClampedStrip::kDensity * 10 / (1.5 * 1.3));
  const Eigen::Matrix3Xd& velocities = sheet.now().state.velocities;
  // The tolerance of the steps, some of them summed, over the masses.
  EXPECT_LT((velocities.row(2).array() - (2 - against_air)).abs().maxCoeff(), 1e-5);
  EXPECT_LT(velocities.topRows<2>().norm(), 1e-5);  // the air slips along a face
}

}  // namespace
}  // namespace pliant
