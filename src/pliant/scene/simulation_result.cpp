#include "pliant/scene/simulation_result.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <nlohmann/json.hpp>

#include "pliant/scene/frame_files.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json statistics(std::vector<T> values) {
  if (values.empty()) return nullptr;
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  const double median =
      (static_cast<double>(values[(n - 1) / 2]) + static_cast<double>(values[n / 2])) / 2;
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {{"min", values.front()},
          {"median", median},
          {"mean", sum / static_cast<double>(n)},
          {"max", values.back()}};
}

// Of one of the costs of a step.
template <class T>
Json of_steps(const StepRecords& records, T SearchCosts::*cost) {
  std::vector<T> costs;
  for (const SearchCosts& step : records.costs) costs.push_back(step.*cost);
  return statistics(std::move(costs));
}

Json phases(const StepRecords& records) {
  const auto of = [&](double SearchCosts::*phase) { return of_steps(records, phase); };
  return {{"assembly", of(&SearchCosts::assembly)}, {"equations", of(&SearchCosts::equations)},
          {"energies", of(&SearchCosts::energies)}, {"pairs", of(&SearchCosts::pairs)},
          {"ways", of(&SearchCosts::ways)},         {"history", of(&SearchCosts::history)}};
}

Json frames(const Simulation& simulation) {
  Json list = Json::array();
  for (const EnergyRow& row : simulation.now().energies) {
    list.push_back({{"index", list.size()}, {"time", row.time}});
  }
  return list;
}

// `time_step` stands beside it.
Json method(const Stepping& time) {
  const bool dynamic = time.kind == SimulationKind::dynamic;
  const auto only = [&](StepSolve solution, double tolerance) {
    return time.solution == solution ? Json(tolerance) : Json(nullptr);
  };
  return {{"kind", name_of(time.kind)},
          {"integrator", dynamic ? Json(name_of(time.integrator)) : Json(nullptr)},
          {"solve", name_of(time.solution)},
          {"tolerance", only(StepSolve::converged, time.tolerance.value())},
          {"motion_tolerance", only(StepSolve::iterated, time.motion_tolerance.value())},
          {"linear_tolerance", only(StepSolve::linearized, time.linear_tolerance)},
          {"adaptive", time.adaptive || !dynamic},
          {"friction", name_of(time.friction)}};
}

// What real cloth does and this simulation does not.
Json not_modelled(const Scene& scene) {
  Json list = Json::array();
  if (!scene.contact.friction) {
    list.push_back(scene.obstacles.empty() ? "contact" : "contact of cloth with itself");
  }
  if (!scene.time.friction) list.push_back("internal friction");
  if (!scene.air && scene.time.kind == SimulationKind::dynamic) list.push_back("drag of the air");
  return list;
}

Json crossing_pairs(const Simulation& simulation) {
  const auto crossings = scene_crossings(simulation.now().state.configuration.positions,
                                         simulation.built().faces, simulation.built().bodies);
  return crossings ? Json(crossings->count()) : Json(nullptr);
}

// Of solids.
int element_count(const SceneSystem& built) {
  int count = 0;
  for (const SolidPiece& solid : built.solids) count += solid.mesh.element_count();
  return count;
}

Json obstacles_path(const Scene& scene) {
  if (scene.obstacles.empty()) return nullptr;
  return has_moving_obstacles(scene.obstacles) ? "obstacles" : "obstacles.obj";
}

// Of the steps at whose end something has one.
std::vector<double> contact_distances(const StepRecords& records) {
  std::vector<double> distances = records.distances;
  std::erase_if(distances, [](double distance) { return !std::isfinite(distance); });
  return distances;
}

Json least_of(const std::vector<double>& distances) {
  return distances.empty() ? Json(nullptr) : Json(*std::ranges::min_element(distances));
}

}  // namespace

std::string simulation_text(const Simulation& simulation, const SimulationFacts& facts) {
  const Scene& scene = simulation.scene();
  const SimulationState& now = simulation.now();
  const std::vector<double> distances = contact_distances(now.records);
  const bool meets = !now.records.contacts.empty();
  Json fields = Json::object();
  for (const auto& [name, unit] : frame_fields(simulation)) fields[name] = unit;
  Json json{{"pliant", "simulation/1"},
            {"name", scene.name},
            {"info", scene.info},
            {"command", facts.command},
            {"created", facts.created},
            {"version", facts.version},
            {"scene", scene.file},
            {"scene_sha256", facts.scene_sha256},
            {"threads", facts.threads},
            {"finished", simulation.is_finished()},
            {"triangles", simulation.built().faces.cols()},
            {"vertices", simulation.built().vertices},
            {"elements", element_count(simulation.built())},
            {"steps", now.steps},
            {"time_step", scene.time.step},
            {"method", method(scene.time)},
            {"frames", frames(simulation)},
            {"fields", fields},
            {"seconds_per_step", statistics(now.records.seconds)},
            {"seconds_by_phase", phases(now.records)},
            {"substeps", statistics(now.records.substeps)},
            {"newton_iterations", statistics(now.records.newton_iterations)},
            {"linear_iterations", statistics(now.records.linear_iterations)},
            {"peak_memory_MB", facts.peak_memory},
            {"not_modelled", not_modelled(scene)},
            {"crossing_pairs", crossing_pairs(simulation)},
            {"contacts", statistics(now.records.contacts)},
            {"contact_distance", statistics(distances)},
            {"min_contact_distance", least_of(distances)},
            {"way_tests", meets ? of_steps(now.records, &SearchCosts::way_tests) : Json(nullptr)},
            {"mesh", scene.solids.empty() ? Json("cloth.obj") : Json(nullptr)},
            {"obstacles", obstacles_path(scene)},
            {"solids", scene.solids.empty() ? Json(nullptr) : Json("solids.vtu")},
            {"energy", "energy.csv"},
            {"clips", scene.clips.empty() ? Json(nullptr) : Json("clips.csv")},
            {"warnings", simulation.built().warnings}};
  return json.dump(2) + "\n";
}

}  // namespace pliant
