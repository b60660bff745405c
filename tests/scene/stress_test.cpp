// Scenes drawn at random that ask much of contact: each step ends, nothing passes through anything,
// which an exact test tells that knows nothing of contact, and no energy comes from nowhere.

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/crossings.h"
#include "pliant/scene/obstacle_reach.h"
#include "pliant/scene/scene_crossings.h"

#include "scene/random_scene.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using test::RandomScene;

/// How a scene went.
struct Outcome {
  int steps = 0;
  int halved = 0;           ///< of them
  int most_iterations = 0;  ///< linear systems of a step, with its parts
  bool without_room = false;
  std::optional<std::string> fault;
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

std::optional<std::string> crossing_of(const Simulation& simulation) {
  const auto found = scene_crossings(simulation.now().state.configuration.positions,
                                     simulation.built().faces, simulation.built().bodies);
  const auto& cloth = found.value().of_cloth;
  bool crosses = !std::ranges::all_of(cloth, [&](const auto& faces) {
    return is_held(simulation, faces[0]) && is_held(simulation, faces[1]);
  });
  for (const auto& body : found->of_bodies) {
    crosses |= !std::ranges::all_of(
        body.faces, [&](const auto& faces) { return is_held(simulation, faces[0]); });
  }
  return crosses ? std::optional(found->text()) : std::nullopt;
}

// By the same test as faces, between whose vertices obstacles may come.
std::optional<std::string> vertex_in_obstacle(const Simulation& simulation) {
  for (const ObstacleReach& reach :
       obstacle_reaches(simulation.scene(), simulation.built(), simulation.now().state)) {
    if (!reach.vertex) continue;
    return fmt::format("vertex {} is {:.3g} m inside {}", reach.vertex->number, reach.vertex->depth,
                       reach.obstacle);
  }
  return std::nullopt;
}

double total_energy(Simulation& simulation) {
  simulation.record_frame();
  const EnergyRow& row = simulation.now().energies.back();
  return row.total() - row.outside;
}

std::optional<std::string> fault_of(const Simulation& simulation, double gained, double before) {
  if (!simulation.now().state.configuration.positions.allFinite()) return "is not finite";
  if (auto crossing = crossing_of(simulation)) return crossing;
  if (auto vertex = vertex_in_obstacle(simulation)) return vertex;
  if (gained <= 1e-9) return std::nullopt;
  return fmt::format("gained {:.3g} J of {:.3g} J", gained, before);
}

// Where nothing is led there is always room.
Outcome outcome_of(const RandomScene& scene) {
  Outcome outcome;
  Simulation simulation = scene.simulation();
  double energy = total_energy(simulation);
  outcome.fault = crossing_of(simulation);
  while (!simulation.is_finished() && !outcome.fault) {
    try {
      simulation.advance();
    } catch (const SolverError& error) {
      outcome.without_room = scene.is_led();
      if (!scene.is_led()) outcome.fault = error.what();
      break;
    }
    const auto& records = simulation.now().records;
    ++outcome.steps;
    outcome.halved += records.substeps.back() > 1 ? 1 : 0;
    outcome.most_iterations = std::max(outcome.most_iterations, records.newton_iterations.back());
    const double before = std::exchange(energy, total_energy(simulation));
    outcome.fault = fault_of(simulation, scene.is_led() ? 0 : energy - before, before);
  }
  return outcome;
}

/// Of all scenes with an ingredient.
struct Tally {
  int scenes = 0, steps = 0, halved = 0, most_iterations = 0, without_room = 0, faults = 0;

  void add(const Outcome& outcome) {
    ++scenes;
    steps += outcome.steps;
    halved += outcome.halved;
    most_iterations = std::max(most_iterations, outcome.most_iterations);
    without_room += outcome.without_room ? 1 : 0;
    faults += outcome.fault ? 1 : 0;
  }
};

void print(const std::map<std::string, Tally>& tallies) {
  std::cout << fmt::format("{:36}{:>7}{:>7}{:>9}{:>9}{:>9}{:>8}\n", "scenes with", "scenes",
                           "steps", "halved", "systems", "no room", "faults");
  for (const auto& [name, tally] : tallies) {
    std::cout << fmt::format("{:36}{:7}{:7}{:9}{:9}{:9}{:8}\n", name, tally.scenes, tally.steps,
                             tally.halved, tally.most_iterations, tally.without_room, tally.faults);
  }
}

void stress(int first, int count) {
  constexpr const char *kAll = "any of these", *kClosed = "nothing that is led";
  if (!crossing_triangles(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0))) {
    GTEST_SKIP() << "built without CGAL";
  }
  std::map<std::string, Tally> tallies;
  for (int seed = first; seed < first + count; ++seed) {
    const RandomScene scene(static_cast<std::uint64_t>(seed));
    const Outcome outcome = outcome_of(scene);
    EXPECT_FALSE(outcome.fault) << "scene " << seed << " " << *outcome.fault << "\n"
                                << scene.text();
    for (const std::string& ingredient : scene.ingredients()) tallies[ingredient].add(outcome);
    if (!scene.is_led()) tallies[kClosed].add(outcome);
    tallies[kAll].add(outcome);
  }
  print(tallies);
  EXPECT_GT(tallies[kClosed].scenes, count / 10);
  // Bodies and clips that are led at metres a second, mostly in steps that may not be halved.
  EXPECT_LE(tallies[kAll].without_room, 2 * count / 5);
}

TEST(Stress, LetsNothingThrough) { stress(14, 8); }

TEST(SlowStress, LetsNothingThrough) {
  stress(test::asked_for("PLIANT_STRESS_FIRST", 1000), test::asked_for("PLIANT_STRESS_SCENES", 8));
}

}  // namespace
}  // namespace pliant
