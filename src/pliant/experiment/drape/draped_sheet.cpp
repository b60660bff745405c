#include "pliant/experiment/drape/draped_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/drape/drape_schedule.h"
#include "pliant/experiment/drape/platform.h"
#include "pliant/experiment/drape/round_sheet.h"
#include "pliant/experiment/virtual_sheet.h"
#include "pliant/geometry/crossings.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/static_solver.h"
#include "pliant/solver/time_stepper.h"

namespace pliant {
namespace {

constexpr double kStep = 0.01;         // s
constexpr double kAirDrag = 2;         // of a plate across its way
constexpr double kUnevenness = 1e-5;   // m, standard deviation
constexpr double kPlatformSag = 2e-5;  // m, that a point sinks into it by its weight
constexpr double kQuiet = 1e-3;        // m/s
constexpr double kLongestRest = 8;     // s
constexpr double kLongestEdge = 0.6;   // of the bending length
constexpr int kMostIterations = 2000;  // of the equilibrium at the end
constexpr double kForceTolerance = 1e-5, kOfWeight = 1e-3;  // of an equilibrium (SheetSystem)

/// The specimen as a mechanical system.
class DrapeSystem {
 public:
  DrapeSystem(const RoundSheet& sheet, const Material& material)
      : system_(sheet.mesh.positions, material.density * vertex_areas(sheet.mesh)) {
    for (const int vertex : sheet.held) system_.coordinates().prescribe(vertex);
    warnings_ = add_cloth(system_, sheet.mesh, held_beyond_range(material), {}).warnings;
    system_.add(std::make_shared<PointForces>(kDrapeGravity, system_.masses()));
    system_.add(std::make_shared<Platform>(kDrapePlatform, system_.masses(),
                                           kStandardGravity / kPlatformSag));
    system_.finish();
  }

  const System& system() const { return system_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// At rest, its free points at heights that scatter.
  State uneven(RandomStream& chance) const {
    State state = system_.initial_state();
    for (int i = 0; i < system_.points(); ++i) {
      if (!system_.coordinates().is_free(i)) continue;
      state.configuration.positions(2, i) += kUnevenness * chance.normal();
    }
    return state;
  }

  double tolerance() const {
    const double weight = kStandardGravity * system_.masses().sum() / system_.points();
    return std::min(kForceTolerance, kOfWeight * weight);
  }

 private:
  System system_;
  std::vector<std::string> warnings_;
};

/// Goes the way of the schedule, and on until nothing moves any more.
void come_to_rest(const System& system, const TriangleMesh& mesh, const DrapeSchedule& schedule,
                  const StopToken& stop, State& state) {
  TimeStepper stepper(system,
                      {.step = kStep, .air = Air{.drag = kAirDrag}, .schedule = schedule.controls},
                      mesh.triangles);
  const auto moves = [&] { return state.velocities.colwise().norm().maxCoeff() > kQuiet; };
  while (state.time < schedule.duration ||
         (moves() && state.time < schedule.duration + kLongestRest)) {
    stop.throw_if_requested();
    stepper.advance(state);
  }
}

void find_equilibrium(const DrapeSystem& sheet, const DrapeSchedule& schedule,
                      const StopToken& stop, State& state) {
  StaticSolver solver(sheet.system(), {.tolerance = sheet.tolerance(),
                                       .max_iterations = kMostIterations,
                                       .reuse_factor = true,
                                       .stop = stop});
  const NewtonSummary found = solver.find_equilibrium(state, schedule.controls(state.time));
  if (!found.converged) {
    throw SolverError("the equilibrium of a draped specimen", found.iterations, found.residual);
  }
}

/// Of the direction that bends most easily, without friction (m).
double shortest_bending_length(const Material& material) {
  double least = std::numeric_limits<double>::infinity();
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    least = std::min(least, law_of(material, name)->elastic_secant(0));
  }
  return std::cbrt(kStrainPerCurvature * least / (material.density * kStandardGravity));
}

void warn_of_coarse_mesh(const Material& material, double edge,
                         std::vector<std::string>& warnings) {
  const double length = shortest_bending_length(material);
  if (edge <= kLongestEdge * length) return;
  warnings.push_back(
      fmt::format("the mesh is too coarse for its folds: edges of {:.2g} mm, and a bending length "
                  "of {:.2g} mm; "
                  "the coefficient comes out too large (edges of {:.2g} mm would do)",
                  1e3 * edge, 1e3 * length, 1e3 * kLongestEdge * length));
}

void judge(const TriangleMesh& shape, DrapedSheet& draped) {
  if (const auto crossings = crossing_triangles(shape.positions, shape.triangles)) {
    draped.crossings = static_cast<int>(crossings->size());
  }
  if (draped.crossings == 0) return;
  draped.warnings.push_back(fmt::format(
      "the draped sheet passes through itself ({} pairs of triangles): it is too limp for a test "
      "that does not feel the cloth on itself, and would cover more",
      draped.crossings));
}

}  // namespace

void require_drapable(const Material& material, const Location& where) {
  require_whole_sheet(material, where);
  if (!needs_grid(material)) return;
  throw InputError(where, "the springs of " + quoted_value(material.name) + " need a grid",
                   "a material of `membrane: stvk` or `soft-constraint`: a round specimen has an "
                   "irregular mesh");
}

DrapedSheet drape(const Material& material, const DrapeSetup& setup, RandomStream chance,
                  const DrapeWork& work) {
  PLIANT_ASSERT(material.density > 0, "its weight drapes a sheet");
  RoundSheet sheet = round_sheet(setup, chance.uniform(0, 2 * std::numbers::pi));
  const DrapeSystem specimen(sheet, material);
  const DrapeSchedule schedule = drape_schedule(setup);
  State state = specimen.uneven(chance);
  with_threads(work.threads, [&] {
    come_to_rest(specimen.system(), sheet.mesh, schedule, work.stop, state);
    find_equilibrium(specimen, schedule, work.stop, state);
  });
  DrapedSheet draped;
  draped.warnings = specimen.warnings();
  warn_of_coarse_mesh(material, setup.edge, draped.warnings);
  draped.shape = std::move(sheet.mesh);
  draped.shape.positions = state.configuration.positions;
  draped.silhouette = silhouette_of(draped.shape.positions, draped.shape.triangles, setup.disc / 2);
  draped.figures = fold_figures(draped.silhouette.radii, setup.overhang());
  draped.figures.coefficient = drape_coefficient(
      draped.silhouette.area, std::numbers::pi * setup.disc * setup.disc / 4, sheet.flat_area);
  judge(draped.shape, draped);
  return draped;
}

}  // namespace pliant
