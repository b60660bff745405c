// Cloth on bodies of meshes, at rest, led and deforming: nothing passes through, which an exact
// test tells that knows nothing of contact; friction is Coulomb's.

#include "scene/body_scene.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::BodyScene;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr const char* kSheet =
    "cloth:\n"
    "  - {name: sheet, mesh: {grid: 120 mm x 120 mm, nodes: 13x13}, material: jersey.json,\n"
    "     place: {translate: [-0.06, -0.06, 0]}}\n";

size_t crossings(const Simulation& simulation) {
  const auto found = scene_crossings(simulation.now().state.configuration.positions,
                                     simulation.built().faces, simulation.built().bodies);
  return found ? found->count() : 0;
}

/// Steps to the end; after each, no faces cross.
void expect_no_crossings(Simulation& simulation) {
  while (!simulation.is_finished()) {
    simulation.advance();
    ASSERT_EQ(crossings(simulation), 0u) << simulation.now().state.time;
  }
}

/// Heights of all cloth (m).
Eigen::VectorXd heights(const Simulation& simulation) {
  return simulation.now().state.configuration.positions.row(2).head(simulation.built().vertices);
}

std::string with(const std::string& obstacles, const std::string& contact,
                 const std::string& duration) {
  return fmt::format("{}obstacles:\n{}contact: {}\ntime: {{step: 5 ms, duration: {}}}\n", kSheet,
                     obstacles, contact, duration);
}

TEST(SlowMeshBody, CarriesWhatFallsOnIt) {
  const BodyScene folder;
  folder.write_ball("ball.obj", 50, -53);
  for (const char* contact : {"{thickness: 2 mm}", "{thickness: 2 mm, friction: 0.5}"}) {
    Simulation simulation = folder.simulated(with(
        "  - {name: ball, mesh: {file: ball.obj, unit: mm}, friction: 0.5}\n", contact, "600 ms"));
    expect_no_crossings(simulation);
    // Facets of the ball lie a little inside it; the sheet hangs down all around.
    EXPECT_NEAR(heights(simulation).maxCoeff(), -3e-3 + 1e-3, 1.5e-3) << contact;
    EXPECT_LT(heights(simulation).minCoeff(), -0.03) << contact;
  }
}

// On a facet of a mesh cloth lies as on the plane that the facet is of.
TEST(SlowMeshBody, IsLikeAPlaneWhereItIsFlat) {
  const BodyScene folder;
  folder.write_plate("plate.obj", 200, -5);
  Eigen::Matrix3Xd ends[2];
  const char* kFloors[] = {
      "  - {name: floor, mesh: {file: plate.obj, unit: mm}, friction: 0.3}\n",
      "  - {name: floor, plane: {point: [0, 0, -0.005], normal: [0, 0, 1]}, friction: 0.3}\n"};
  for (int k = 0; k < 2; ++k) {
    Simulation simulation = folder.simulated(with(kFloors[k], "{thickness: 2 mm}", "300 ms"));
    while (!simulation.is_finished()) simulation.advance();
    ends[k] = simulation.now().state.configuration.positions.leftCols(169);
  }
  EXPECT_LT((ends[0] - ends[1]).colwise().norm().maxCoeff(), 2e-4);
}

TEST(SlowMeshBody, ThatIsLedTakesClothAlong) {
  const BodyScene folder;
  folder.write_ball("ball.obj", 50, -53);
  Simulation simulation = folder.simulated(
      with("  - {name: ball, mesh: {file: ball.obj, unit: mm}, friction: 0.5,\n"
           "     motion: {keyframes: [{time: 0 s}, {time: 200 ms, translate: [0, 0, 0.3],\n"
           "              rotate: {axis: [1, 0, 0], angle: 90 deg}}]}}\n",
           "{thickness: 2 mm, friction: 0.5}", "300 ms"));
  expect_no_crossings(simulation);
  EXPECT_GT(heights(simulation).maxCoeff(), 0.29);
}

// At 20 m/s it would be on the other side within one step.
TEST(MeshBody, CatchesWhatWouldBePastItInOneStep) {
  const BodyScene folder;
  folder.write_plate("plate.obj", 300, -20);
  Simulation simulation = folder.simulated(
      with("  - {name: plate, mesh: {file: plate.obj, unit: mm}, friction: 0.5,\n"
           "     motion: {keyframes: [{time: 0 s}, {time: 50 ms, translate: [0, 0, 1]}]}}\n",
           "{thickness: 2 mm}", "50 ms"));
  expect_no_crossings(simulation);
  EXPECT_GT(heights(simulation).minCoeff(), 0.98);
}

// The ball swells to twice its size and shrinks again.
TEST(SlowMeshSequence, PushesAsItsFramesHaveIt) {
  const BodyScene folder;
  for (int frame = 0; frame < 5; ++frame) {
    folder.write_ball(fmt::format("balls/{:03}.obj", frame + 7), 25 + 12.5 * (2 - abs(frame - 2)),
                      -60);
  }
  Simulation simulation = folder.simulated(with(
      "  - {name: ball, sequence: {files: balls/%03d.obj, rate: 10 Hz, unit: mm}, friction: 0.5}\n",
      "{thickness: 2 mm, friction: 0.5}", "700 ms"));
  double highest = -1;
  while (!simulation.is_finished()) {
    simulation.advance();
    ASSERT_EQ(crossings(simulation), 0u) << simulation.now().state.time;
    highest = std::max(highest, heights(simulation).maxCoeff());
    // Between the frames half the way.
    if (std::abs(simulation.now().state.time - 0.05) < 1e-9) {
      const BodyPiece& ball = simulation.built().bodies.front();
      EXPECT_NEAR(simulation.now().state.configuration.positions(2, ball.first_point), -0.02875,
                  1e-12);
    }
  }
  EXPECT_GT(highest, -0.012);                         // the pole came up to -10 mm
  EXPECT_LT(heights(simulation).maxCoeff(), -0.025);  // and went back to -35, under wrinkles
}

// A plate that rises to the sheet and on.
TEST(MeshSequence, InPlyIsTheSameAsInObj) {
  const BodyScene folder;
  for (const int frame : {0, 1}) {
    const double height = -3 + 20 * frame;
    folder.write_plate(fmt::format("rise/{}.obj", frame), 300, height);
    folder.write(fmt::format("rise/{}.ply", frame),
                 fmt::format("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                             "property double y\nproperty double z\nelement face 2\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             "-150 -150 {0}\n150 -150 {0}\n150 150 {0}\n-150 150 {0}\n"
                             "3 0 1 2\n3 0 2 3\n",
                             height));
  }
  Eigen::Matrix3Xd ends[2];
  const char* kFiles[] = {"rise/%d.obj", "rise/%d.ply"};
  for (int k = 0; k < 2; ++k) {
    Simulation simulation = folder.simulated(
        with(fmt::format("  - {{name: lift, sequence: {{files: {}, rate: 10 Hz, unit: mm}}}}\n",
                         kFiles[k]),
             "{thickness: 2 mm}", "100 ms"));
    while (!simulation.is_finished()) simulation.advance();
    EXPECT_GT(heights(simulation).minCoeff(), 0.017) << kFiles[k];
    ends[k] = simulation.now().state.configuration.positions;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

/// How fast the sheet slides down a plate of a mesh under a gravity that slopes (m/s).
double sliding_speed(double degrees) {
  const BodyScene folder;
  folder.write_plate("plate.obj", 2000, -1.9);
  const double angle = degrees * std::numbers::pi / 180;
  Simulation simulation = folder.simulated(
      with("  - {name: plate, mesh: {file: plate.obj, unit: mm}, friction: 0.5}\n",
           "{thickness: 2 mm}", "500 ms") +
      fmt::format("gravity: [{}, 0, {}]\n", 9.80665 * std::sin(angle), -9.80665 * std::cos(angle)));
  while (!simulation.is_finished()) simulation.advance();
  return simulation.now().state.velocities.row(0).head(169).mean();
}

TEST(MeshBody, HoldsAndLetsSlideAsCoulombHasIt) {
  const double limit = std::atan(0.5) * 180 / std::numbers::pi;
  EXPECT_LT(sliding_speed(limit - 0.5), 1e-3);
  EXPECT_GT(sliding_speed(limit + 0.5), 1e-2);
  const double expected = 9.80665 * (std::sin(std::numbers::pi / 4) * 0.5) * 0.5;
  EXPECT_NEAR(sliding_speed(45), expected, 0.05 * expected);
}

// What friction takes while the sheet slides, on a mesh and on a plane alike.
TEST(Rubbing, IsForceTimesWay) {
  const BodyScene folder;
  folder.write_plate("plate.obj", 2000, -1.9);
  const double along = 9.80665 * std::sin(std::numbers::pi / 4);
  for (const char* floor : {"mesh: {file: plate.obj, unit: mm}",
                            "plane: {point: [0, 0, -0.0019], normal: [0, 0, 1]}"}) {
    Simulation simulation =
        folder.simulated(with(fmt::format("  - {{name: floor, {}, friction: 0.5}}\n", floor),
                              "{thickness: 2 mm}", "500 ms") +
                         fmt::format("gravity: [{}, 0, {}]\n", along, -along));
    const auto place = [&] {
      return simulation.now().state.configuration.positions.row(0).head(169).mean();
    };
    const double start = place();
    while (!simulation.is_finished()) simulation.advance();
    simulation.record_frame();
    const EnergyRow& end = simulation.now().energies.back();
    const double mass = simulation.built().system->masses().sum();
    const double expected = 0.5 * mass * along * (place() - start);
    EXPECT_NEAR(end.rubbing, expected, 0.05 * expected) << floor;
    EXPECT_LE(end.rubbing, end.work) << floor;
    EXPECT_GT(end.contact, 0) << floor;
    EXPECT_LT(end.contact, end.stored + mass * along * (place() - start)) << floor;
    EXPECT_GT(simulation.now().records.contacts.back(), 100) << floor;
  }
}

TEST(SlowMeshBody, IsGoneOnWithToTheSameBits) {
  const BodyScene folder;
  folder.write_ball("ball.obj", 50, -53);
  const std::string scene =
      with("  - {name: ball, mesh: {file: ball.obj, unit: mm}, friction: 0.5}\n",
           "{thickness: 2 mm, friction: 0.5}", "200 ms");
  Simulation whole = folder.simulated(scene);
  SimulationState half;
  while (!whole.is_finished()) {
    whole.advance();
    if (whole.now().steps == 20) half = whole.now();
  }
  Simulation resumed = folder.simulated(scene);
  resumed.resume(half);
  while (!resumed.is_finished()) resumed.advance();
  EXPECT_EQ(resumed.now().state.configuration.positions, whole.now().state.configuration.positions);
}

// Two plates come together.
TEST(MeshBody, LeavesNoRoomWhereItClosesOnAnother) {
  const BodyScene folder;
  folder.write_plate("lower.obj", 300, -20);
  folder.write_plate("upper.obj", 300, 20);
  Simulation simulation = folder.simulated(
      with("  - {name: lower, mesh: {file: lower.obj, unit: mm}}\n"
           "  - {name: upper, mesh: {file: upper.obj, unit: mm},\n"
           "     motion: {keyframes: [{time: 0 s}, {time: 200 ms, translate: [0, 0, -0.05]}]}}\n",
           "{thickness: 2 mm}", "300 ms"));
  try {
    while (!simulation.is_finished()) simulation.advance();
    FAIL() << "the plates passed through each other";
  } catch (const SolverError& error) {
    EXPECT_THAT(error.what(), HasSubstr("leaves what it meets no room: nearest to the cloth are "));
    const std::string pair =
        "[0-9.e-]+ mm between (vertex [0-9]+ and its face|its vertex [0-3] and face|edge [0-9-]+ "
        "and its edge|its edge [0-9-]+ and edge) [0-9-]+; [^ ]*scene.yaml:";
    EXPECT_THAT(error.what(), ContainsRegex("\"lower\" \\(" + pair + "6\\)"));
    EXPECT_THAT(error.what(), ContainsRegex("\"upper\" \\(" + pair + "7\\)"));
  }
  EXPECT_EQ(crossings(simulation), 0u);
}

struct RefusedBody {
  const char* name;
  std::string obstacle, problem;
};

void PrintTo(const RefusedBody& refused, std::ostream* out) { *out << refused.name; }

class BodyRefusal : public ::testing::TestWithParam<RefusedBody> {};

TEST_P(BodyRefusal, SaysWhatIsWrong) {
  const BodyScene folder;
  folder.write_ball("ball.obj", 50, 0);
  folder.write("blade.obj", "v -3 12 -2\nv -2 12 -2\nv -2.5 12 3\nf 1 2 3\n");
  for (const int frame : {1, 2, 4}) folder.write_ball(fmt::format("gap/{}.obj", frame), 20, -50);
  folder.write_ball("other/1.obj", 20, -50);
  folder.write_plate("other/2.obj", 20, -50);
  try {
    folder.simulated(with("  - " + GetParam().obstacle + "\n", "{thickness: 2 mm}", "1 s"));
    FAIL() << "was not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().problem));
  }
}

const RefusedBody kRefused[] = {
    {"NoUnit", "{name: a, mesh: {file: ball.obj}}", "mesh.unit"},
    {"NoFile", "{name: a, mesh: {file: bull.obj, unit: mm}}", "bull.obj\" does not exist"},
    {"Crossing", "{name: a, mesh: {file: ball.obj, unit: mm}}",
     "scene.yaml:6: obstacles[0]: cloth begins passing through it"},
    // Below the diagonal of cell (5, 7) of 12 x 12.
    {"CrossingInOnePlace", "{name: a, mesh: {file: blade.obj, unit: mm}}",
     "1 pair of faces, 178, counted from 0 over all cloth, and 0 of \"a\""},
    {"TwoCoefficients",
     "{name: a, mesh: {file: ball.obj, unit: mm}, friction: {static: 0.5, kinetic: 0.4}}",
     "two coefficients"},
    {"AGap", "{name: a, sequence: {files: gap/%d.obj, rate: 10 Hz, unit: mm}}",
     "gap/3.obj\" does not exist"},
    {"NoFirst", "{name: a, sequence: {files: gap/%d.obj, first: 5, rate: 10 Hz, unit: mm}}",
     "the last file there is 4"},
    {"NoPattern", "{name: a, sequence: {files: gap/1.obj, rate: 10 Hz, unit: mm}}",
     "does not tell where the number stands"},
    {"NoFiles", "{name: a, sequence: {files: gap/%04d.obj, rate: 10 Hz, unit: mm}}",
     "no such file is in"},
    {"AnotherTopology", "{name: a, sequence: {files: other/%d.obj, rate: 10 Hz, unit: mm}}",
     "has 4 vertices and 2 faces"},
    {"RateWithoutUnit", "{name: a, sequence: {files: other/%d.obj, rate: 10, unit: mm}}",
     "sequence.rate"},
    {"LedSequence",
     "{name: a, sequence: {files: other/%d.obj, rate: 10 Hz, unit: mm},\n"
     "     motion: {keyframes: [{time: 0 s}]}}",
     "moves what its frames move"},
};

INSTANTIATE_TEST_SUITE_P(Body, BodyRefusal, ::testing::ValuesIn(kRefused),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace pliant
