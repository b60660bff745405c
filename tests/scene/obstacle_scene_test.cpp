// Cloth on solid bodies: it stays outside, rests and slides as Coulomb has it, and gains no energy.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "io/input_error_of.h"
#include "scene/simulated_scene.h"

namespace pliant {
namespace {

using test::simulated;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// A sheet of 40 mm that lies on a plane, level in its own axes, under a gravity that slopes. It
/// begins where the barrier carries its weight, so that it is pressed on from the start.
Simulation on_slope(double degrees, const std::string& friction) {
  const double angle = degrees * std::numbers::pi / 180;
  return simulated(fmt::format(
      "cloth:\n"
      "  - {{name: sheet, mesh: {{grid: 40 mm x 40 mm, nodes: 3x3}}, material: jersey.json}}\n"
      "obstacles:\n"
      "  - {{name: floor, plane: {{point: [0, 0, -0.000944], normal: [0, 0, 1]}}, friction: {}}}\n"
      "gravity: [{}, 0, {}]\n"
      "time: {{step: 5 ms, duration: 100 s}}\n",
      friction, 9.80665 * std::sin(angle), -9.80665 * std::cos(angle)));
}

/// How far the sheet moves down the slope in some time (m).
double slides(Simulation& simulation, double seconds) {
  const auto place = [&] { return simulation.now().state.configuration.positions.row(0).mean(); };
  const double before = place();
  const double end = simulation.now().state.time + seconds - 1e-9;
  while (simulation.now().state.time < end) simulation.advance();
  return place() - before;
}

TEST(Slope, HoldsWhatIsNotSteeperThanFriction) {
  const double limit = std::atan(0.5) * 180 / std::numbers::pi;
  Simulation held = on_slope(limit - 0.5, "0.5");
  slides(held, 0.5);
  EXPECT_LT(std::abs(slides(held, 10)), 10e-6);
  EXPECT_LT(held.now().state.velocities.cwiseAbs().maxCoeff(), 1e-5);
  Simulation sliding = on_slope(limit + 0.5, "0.5");
  slides(sliding, 0.5);
  EXPECT_GT(slides(sliding, 0.5), 5e-3);
}

TEST(Slope, LetsSlideAgainstKineticFriction) {
  constexpr double kAngle = 40 * std::numbers::pi / 180, kKinetic = 0.4;
  Simulation sheet = on_slope(40, "{static: 0.5, kinetic: 0.4}");
  slides(sheet, 0.5);
  const double first = slides(sheet, 0.25), second = slides(sheet, 0.25);
  const double acceleration = (second - first) / (0.25 * 0.25);
  const double expected = 9.80665 * (std::sin(kAngle) - kKinetic * std::cos(kAngle));
  EXPECT_NEAR(acceleration, expected, 0.01 * expected);
}

// Between the two slopes what rests stays, and what slides goes on.
TEST(SlowSlope, TellsStickingFromSliding) {
  Simulation sheet = on_slope(24, "{static: 0.5, kinetic: 0.4}");
  EXPECT_LT(std::abs(slides(sheet, 2)), 10e-6);
  Simulation started = on_slope(24, "{static: 0.44, kinetic: 0.4}");
  slides(started, 0.5);
  EXPECT_GT(slides(started, 0.5), 1e-2);
}

/// The largest rise of the total energy from frame to frame (J), and the energy at the start.
struct Energies {
  double rise = 0, start = 0;
};
Energies energies_of(Simulation& simulation, int steps) {
  Energies energies;
  simulation.record_frame();
  energies.start = std::abs(simulation.now().energies.back().total());
  for (int i = 0; i < steps; ++i) {
    const double before = simulation.now().energies.back().total();
    simulation.advance();
    simulation.record_frame();
    energies.rise = std::max(energies.rise, simulation.now().energies.back().total() - before);
  }
  return energies;
}

constexpr const char* kDrape =
    "cloth:\n"
    "  - name: sheet\n"
    "    mesh: {{grid: 300 mm x 300 mm, nodes: 31x31, diagonals: alternate}}\n"
    "    material: jersey.json\n"
    "    place: {{translate: [-0.15, -0.15, 0]}}\n"
    "{}"
    "time: {{step: {}, duration: 10 s{}}}\n";

TEST(SlowDrape, StaysOutsideOfABallAndGainsNoEnergy) {
  const std::string ball =
      "obstacles:\n"
      "  - {name: ball, sphere: {centre: [0, 0, -0.105], radius: 100 mm}, friction: 0.3}\n";
  for (const char* solve : {"", ", solve: converged"}) {
    Simulation sheet = simulated(fmt::format(fmt::runtime(kDrape), ball, "5 ms", solve));
    const Energies energies = energies_of(sheet, 80);
    EXPECT_LT(energies.rise, 1e-9) << solve;
    const auto& distances = sheet.now().records.distances;
    ASSERT_EQ(distances.size(), 80u);
    EXPECT_GT(*std::ranges::min_element(distances), 0) << solve;
    // It hangs over the ball: the middle is held, the corners are lower by more than the radius.
    const auto heights = sheet.now().state.configuration.positions.row(2);
    EXPECT_NEAR(heights.maxCoeff(), -0.005, 2e-3) << solve;
    EXPECT_LT(heights.minCoeff(), -0.08) << solve;
  }
}

// A step goes further than what is in the way is thick.
TEST(Drape, IsNotCarriedThroughThinBodies) {
  const std::string rods =
      "obstacles:\n"
      "  - {name: rod, capsule: {from: [-0.3, 0, -0.12], to: [0.3, 0, -0.12], radius: 10 mm}}\n"
      "  - {name: floor, plane: {point: [0, 0, -0.3], normal: [0, 0, 2]}, friction: 0.2}\n"
      "gravity: [0, 0, -9.81]\n";
  const std::string thrown = fmt::format(fmt::runtime(kDrape), rods, "5 ms", "");
  Simulation sheet = simulated(
      std::string(thrown).replace(thrown.find("    place:"), 0, "    velocity: [0, 0, -5]\n"));
  for (int i = 0; i < 60; ++i) sheet.advance();
  const auto& positions = sheet.now().state.configuration.positions;
  EXPECT_GT(*std::ranges::min_element(sheet.now().records.distances), 0);
  EXPECT_GT(positions.row(2).minCoeff(), -0.3);
  // Who began above the rod lies on it.
  for (int i = 0; i < positions.cols(); ++i) {
    const bool above = std::abs(sheet.built().start.configuration.positions(1, i)) < 2e-3;
    EXPECT_TRUE(!above || positions(2, i) > -0.12) << i;
  }
}

/// Two sheets that fall side by side, thrown; a ball may be in the way of the first.
std::string two_sheets(const std::string& obstacles, const std::string& more) {
  std::string cloth = "cloth:\n";
  for (const int i : {0, 1}) {
    cloth += fmt::format(
        "  - {{name: sheet{}, mesh: {{grid: 200 mm x 200 mm, nodes: 11x11}}, material: "
        "jersey.json,\n"
        "     place: {{translate: [{}, 0, 0]}}, velocity: [0, 0, -2]}}\n",
        i, i);
  }
  return cloth + obstacles + "time: {duration: 10 s, " + more + "}\n";
}

constexpr const char* kBallBelowTheFirst =
    "obstacles:\n"
    "  - {name: ball, sphere: {centre: [0.12, 0.11, -0.08], radius: 50 mm}, friction: 0.3}\n";

void advance_to(Simulation& simulation, double time) {
  while (simulation.now().state.time < time - 1e-9) simulation.advance();
}

// What meets something does not brake what is far away.
TEST(Drape, LeavesAloneWhoMeetsNothing) {
  for (const char* step : {"step: 5 ms", "step: 5 ms, solve: converged"}) {
    Simulation met = simulated(two_sheets(kBallBelowTheFirst, step));
    Simulation free = simulated(two_sheets("", step));
    advance_to(met, 0.2);
    advance_to(free, 0.2);
    const auto far = Eigen::seqN(121, 121);
    const Eigen::Matrix3Xd& reached = met.now().state.configuration.positions;
    EXPECT_GT(reached.row(2).head(121).maxCoeff(), -0.2);
    const double difference = (reached - free.now().state.configuration.positions)(Eigen::all, far)
                                  .colwise()
                                  .norm()
                                  .maxCoeff();
    EXPECT_LT(difference, 1e-5) << step << ": of a fall of 0.6 m";
  }
}

// A step that is searched for with few linear systems loses as much in an impact as an exact one.
TEST(Drape, LosesInAnImpactWhatAnExactStepLoses) {
  const auto energy_after = [](const char* step) {
    Simulation sheets = simulated(two_sheets(kBallBelowTheFirst, step));
    advance_to(sheets, 0.1);
    sheets.record_frame();
    return sheets.now().energies.back().total();
  };
  constexpr double kKinetic = 2 * 0.15 * 0.2 * 0.2 * 2 * 2 / 2;  // of both sheets at the start
  const double exact = energy_after("step: 5 ms, solve: converged");
  EXPECT_NEAR(energy_after("step: 5 ms"), exact, 0.03 * kKinetic);
  EXPECT_LT(exact, 0.6 * kKinetic);
}

/// A square of 40 mm on a plate, beginning where the barrier carries its weight.
Simulation on_plate(const std::string& friction, const std::string& keyframes) {
  return simulated(fmt::format(
      "cloth:\n"
      "  - {{name: sheet, mesh: {{grid: 40 mm x 40 mm, nodes: 5x5}}, material: jersey.json}}\n"
      "obstacles:\n"
      "  - {{name: plate, box: {{centre: [0.02, 0.02, -0.050944], size: [0.5, 0.5, 0.1]}},\n"
      "     friction: {}, motion: {{keyframes: [{}]}}}}\n"
      "gravity: [0, 0, -9.80665]\n"
      "time: {{step: 5 ms, duration: 10 s}}\n",
      friction, keyframes));
}

// Slower than friction can hold it, the plate takes its cloth along; without friction it does not.
TEST(LedObstacles, TakeAlongWhatSticksToThem) {
  const char* slide =
      "{time: 0 s}, {time: 1 s, translate: [0.1, 0, 0]}, {time: 2 s, translate: [0.1, 0, 0.05]}";
  Simulation sticking = on_plate("0.5", slide);
  const double before = sticking.now().state.configuration.positions.row(0).mean();
  advance_to(sticking, 2);
  const auto& carried = sticking.now().state.configuration.positions;
  EXPECT_NEAR(carried.row(0).mean() - before, 0.1, 3e-3);
  EXPECT_NEAR(carried.row(2).mean(), 0.05, 1e-3);
  Simulation slipping = on_plate("0", slide);
  advance_to(slipping, 1);
  EXPECT_NEAR(slipping.now().state.configuration.positions.row(0).mean(), before, 1e-6);
}

// A plate that comes at 10 m/s, 50 mm a step, pushes the sheet before it and does not pass it.
TEST(LedObstacles, DoNotPassWhatIsInTheirWay) {
  Simulation hit = on_plate("0.3", "{time: 0 s}, {time: 0.1 s, translate: [0, 0, 1]}");
  advance_to(hit, 0.1);
  EXPECT_GT(*std::ranges::min_element(hit.now().records.distances), 0);
  EXPECT_GT(hit.now().state.configuration.positions.row(2).minCoeff(), 1 - 0.001);
}

// The plate turns about the world's axis, and takes the sheet along.
TEST(LedObstacles, TurnWithTheirPoints) {
  Simulation turning =
      on_plate("0.5", "{time: 0 s}, {time: 1 s, rotate: {axis: [0, 0, 1], angle: 90 deg}}");
  advance_to(turning, 1);
  const auto& positions = turning.now().state.configuration.positions;
  const Eigen::Vector3d side = positions.col(4) - positions.col(0);
  EXPECT_NEAR(std::atan2(side.y(), side.x()), std::numbers::pi / 2, 0.05);
}

TEST(LedObstacles, AreToldThatTheyLeaveNoRoom) {
  Simulation pressed = simulated(
      "cloth:\n"
      "  - {name: sheet, mesh: {grid: 40 mm x 40 mm, nodes: 3x3}, material: jersey.json}\n"
      "obstacles:\n"
      "  - {name: floor, plane: {point: [0, 0, -0.01], normal: [0, 0, 1]},\n"
      "     motion: {keyframes: [{time: 0 s}, {time: 0.1 s, translate: [0, 0, 0.1]}]}}\n"
      "  - {name: ceiling, plane: {point: [0, 0, 0.03], normal: [0, 0, -1]}}\n"
      "time: {step: 5 ms, duration: 1 s}\n");
  try {
    advance_to(pressed, 0.1);
    FAIL() << "the floor passed the ceiling";
  } catch (const SolverError& error) {
    EXPECT_THAT(error.what(), HasSubstr("what is led leaves what it meets no room: nearest to the "
                                        "cloth are "));
    // Where they stand in the scene, and the vertex that is nearest to each.
    EXPECT_THAT(error.what(), ContainsRegex("\"floor\" \\([0-9.]+ mm from vertex [0-8]; "
                                            "[^ ]*scene.yaml:5\\)"));
    EXPECT_THAT(error.what(), ContainsRegex("\"ceiling\" \\([0-9.]+ mm from vertex [0-8]; "
                                            "[^ ]*scene.yaml:7\\)"));
  }
}

TEST(SceneObstacles, RefuseClothThatBeginsInside) {
  const InputError error = test::input_error_of([] {
    simulated(fmt::format(
        fmt::runtime(kDrape),
        "obstacles:\n  - {name: ball, sphere: {centre: [0, 0, 0], radius: 50 mm}}\n", "5 ms", ""));
  });
  EXPECT_THAT(error.what(), HasSubstr("obstacles[0]"));
  EXPECT_THAT(error.what(), HasSubstr("vertices begin inside \"ball\", the deepest 50 mm below"));
}

// Of the 1,800 faces, whose vertices all lie outside.
TEST(SceneObstacles, RefuseClothThatTheyStandInBetweenItsVertices) {
  for (const char* shape :
       {"capsule: {from: [0.007, 0.003, -1], to: [0.007, 0.003, 1], radius: 1 mm}",
        "box: {centre: [0.007, 0.003, -0.499], size: [0.002, 0.002, 1]}"}) {
    const InputError error = test::input_error_of([&] {
      simulated(fmt::format(fmt::runtime(kDrape),
                            fmt::format("obstacles:\n  - {{name: rod, {}}}\n", shape), "5 ms", ""));
    });
    EXPECT_THAT(error.where().file, ::testing::EndsWith("scene.yaml")) << shape;
    EXPECT_EQ(error.where().line, 8) << shape;
    EXPECT_THAT(error.what(), HasSubstr("\"rod\" begins in the cloth between its vertices: face "
                                        "930, counted from 0 over all cloth, reaches 1 mm below"))
        << shape;
  }
}

// As a run over them may leave it: faces come nearer than their vertices, or touch.
TEST(SceneObstacles, LetClothBeginThatLiesOverThem) {
  for (const char* shape :
       {"capsule: {from: [0.005, -1, -0.0999], to: [0.005, 1, -0.0999], radius: 100 mm}",
        "box: {centre: [0.005, 0, -0.5], size: [0.001, 0.001, 1]}"}) {
    EXPECT_NO_THROW(simulated(
        fmt::format(fmt::runtime(kDrape),
                    fmt::format("obstacles:\n  - {{name: body, {}}}\n", shape), "5 ms", "")))
        << shape;
  }
}

TEST(SceneObstacles, WarnOfWhatIsHeldInsideAndOfWhatBeginsTooNear) {
  const std::string held = fmt::format(
      fmt::runtime(kDrape),
      "pins: [{cloth: sheet, vertices: [0], directions: [z]}, {cloth: sheet, vertices: [1]}]\n"
      "obstacles:\n"
      "  - {name: floor, plane: {point: [0, 0, -0.0001], normal: [0, 0, 1]}}\n"
      "  - {name: ball, sphere: {centre: [-0.145, -0.15, 0], radius: 5.1 mm}}\n",
      "5 ms", "");
  EXPECT_THAT(
      simulated(held).built().warnings,
      ::testing::IsSupersetOf(
          {HasSubstr("959 vertices begin nearer to \"floor\" than a quarter of the thickness"),
           HasSubstr("2 vertices that pins or clips hold begin inside \"ball\"")}));
}

TEST(SceneObstacles, WarnOfEdgesThatAreLongForARoundBody) {
  const Simulation coarse = simulated(fmt::format(
      fmt::runtime(kDrape),
      "obstacles:\n  - {name: pin, sphere: {centre: [0, 0, -0.1], radius: 5 mm}}\n", "5 ms", ""));
  EXPECT_THAT(coarse.built().warnings, ::testing::Contains(HasSubstr("a finer mesh")));
}

// The sheet is held along two sides while a rod between them rises: it presses with hundreds of
// times its weight.
TEST(LedObstacles, KeepAGapBelowClothThatIsPulledTaut) {
  Simulation simulation = simulated(
      "cloth:\n"
      "  - {name: sheet, mesh: {grid: 100 mm x 40 mm, nodes: 21x9}, material: jersey.json}\n"
      "pins:\n"
      "  - {cloth: sheet, within: {box: {low: [-1, -1, -1], high: [0.001, 1, 1]}}}\n"
      "  - {cloth: sheet, within: {box: {low: [0.099, -1, -1], high: [1, 1, 1]}}}\n"
      "obstacles:\n"
      "  - {name: rod, capsule: {from: [0.05, -0.03, -0.007], to: [0.05, 0.07, -0.007],\n"
      "     radius: 5 mm}, friction: 0.3,\n"
      "     motion: {keyframes: [{time: 0 s}, {time: 300 ms, translate: [0, 0, 0.05]}]}}\n"
      "time: {step: 5 ms, duration: 400 ms}\n");
  while (!simulation.is_finished()) simulation.advance();
  EXPECT_GT(std::ranges::min(simulation.now().records.distances), 5e-8);
}

}  // namespace
}  // namespace pliant
