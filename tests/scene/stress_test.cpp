// Scenes drawn at random that ask much of contact: each step ends, nothing passes through anything,
// which an exact test tells that knows nothing of contact, and no energy comes from nowhere.

#include <algorithm>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/crossings.h"
#include "pliant/scene/scene_crossings.h"

#include "scene/random_scene.h"

namespace pliant {
namespace {

using test::RandomScene;

/// How many ended before their time, for want of room, and how many were led.
struct Outcome {
  int without_room = 0, led = 0;
};

/// Whether a face of cloth goes, at least with a vertex, where a clip is told to go: through
/// anything that is told as well.
bool is_held(const Simulation& simulation, int face) {
  const Coordinates& coordinates = simulation.built().system->coordinates();
  return std::ranges::any_of(simulation.built().faces.col(face), [&](int vertex) {
    const int clip = coordinates.clip_of(vertex);
    return clip >= 0 && coordinates.clip_is_prescribed(clip);
  });
}

void expect_no_crossings(const Simulation& simulation) {
  const auto found = scene_crossings(simulation.now().state.configuration.positions,
                                     simulation.built().faces, simulation.built().bodies);
  ASSERT_TRUE(found);
  for (const auto& [one, other] : found->of_cloth) {
    ASSERT_TRUE(is_held(simulation, one) && is_held(simulation, other)) << found->text();
  }
  for (const auto& body : found->of_bodies) {
    for (const auto& faces : body.faces) {
      ASSERT_TRUE(is_held(simulation, faces[0])) << found->text();
    }
  }
}

double total_energy(Simulation& simulation) {
  simulation.record_frame();
  const EnergyRow& row = simulation.now().energies.back();
  return row.total() - row.outside;
}

// Where nothing is led there is always room.
void expect_sound(const RandomScene& scene, Outcome& outcome) {
  Simulation simulation = scene.simulation();
  expect_no_crossings(simulation);
  double energy = total_energy(simulation);
  outcome.led += scene.is_led() ? 1 : 0;
  while (!simulation.is_finished()) {
    try {
      simulation.advance();
    } catch (const SolverError& error) {
      ASSERT_TRUE(scene.is_led()) << error.what();
      ++outcome.without_room;
      return;
    }
    ASSERT_TRUE(simulation.now().state.configuration.positions.allFinite());
    expect_no_crossings(simulation);
    if (::testing::Test::HasFatalFailure()) return;
    const double before = energy;
    energy = total_energy(simulation);
    const double gained = scene.is_led() ? 0 : energy - before;
    ASSERT_LE(gained, 1e-9) << before << " at " << simulation.now().state.time;
  }
}

void stress(int first, int count) {
  if (!crossing_triangles(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0))) {
    GTEST_SKIP() << "built without CGAL";
  }
  Outcome outcome;
  for (int seed = first; seed < first + count; ++seed) {
    const RandomScene scene(static_cast<std::uint64_t>(seed));
    expect_sound(scene, outcome);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << seed << "\n" << scene.text();
  }
  EXPECT_GT(outcome.led, count / 2);
  EXPECT_LE(outcome.without_room, count / 10);
  std::cout << fmt::format(
      "{} scenes, {} of them led: in none does anything pass through anything; in {} what is led "
      "leaves no room, and the run says so\n",
      count, outcome.led, outcome.without_room);
}

TEST(Stress, LetsNothingThrough) { stress(0, 10); }

TEST(SlowStress, LetsNothingThrough) { stress(100, 90); }

}  // namespace
}  // namespace pliant
