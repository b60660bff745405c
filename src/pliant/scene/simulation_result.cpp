#include "pliant/scene/simulation_result.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/io/json_object.h"
#include "pliant/scene/frame_files.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSimulationDocument = "simulation/1";

constexpr std::pair<const char*, double SearchCosts::*> kPhases[] = {
    {"assembly", &SearchCosts::assembly}, {"equations", &SearchCosts::equations},
    {"energies", &SearchCosts::energies}, {"pairs", &SearchCosts::pairs},
    {"ways", &SearchCosts::ways},         {"history", &SearchCosts::history}};

template <class T>
StepStatistics statistics(std::vector<T> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  const double median =
      (static_cast<double>(values[(n - 1) / 2]) + static_cast<double>(values[n / 2])) / 2;
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {values.front(), median, sum / static_cast<double>(n), values.back()};
}

// Of one of the costs of a step.
template <class T>
StepStatistics of_steps(const StepRecords& records, T SearchCosts::*cost) {
  std::vector<T> costs;
  for (const SearchCosts& step : records.costs) costs.push_back(step.*cost);
  return statistics(std::move(costs));
}

std::vector<std::pair<std::string, StepStatistics>> phases_of(const StepRecords& records) {
  std::vector<std::pair<std::string, StepStatistics>> phases;
  for (const auto& [name, phase] : kPhases) phases.emplace_back(name, of_steps(records, phase));
  return phases;
}

// Of the steps at whose end something has one.
std::vector<double> contact_distances(const StepRecords& records) {
  std::vector<double> distances = records.distances;
  std::erase_if(distances, [](double distance) { return !std::isfinite(distance); });
  return distances;
}

SimulationMethod method_of(const Stepping& time) {
  const bool dynamic = time.kind == SimulationKind::dynamic;
  const auto only = [&](StepSolve solution, double tolerance) {
    return time.solution == solution ? std::optional(tolerance) : std::nullopt;
  };
  return {name_of(time.kind),
          dynamic ? name_of(time.integrator) : "",
          name_of(time.solution),
          name_of(time.friction),
          only(StepSolve::converged, time.tolerance.value()),
          only(StepSolve::iterated, time.motion_tolerance.value()),
          only(StepSolve::linearized, time.linear_tolerance),
          time.adaptive || !dynamic};
}

// What real cloth does and this simulation does not.
std::vector<std::string> not_modelled(const Scene& scene) {
  std::vector<std::string> list;
  if (!scene.contact.friction) {
    list.emplace_back(scene.obstacles.empty() ? "contact" : "contact of cloth with itself");
  }
  if (!scene.time.friction) list.emplace_back("internal friction");
  if (!scene.air && scene.time.kind == SimulationKind::dynamic) {
    list.emplace_back("drag of the air");
  }
  return list;
}

std::optional<int> crossing_pairs(const Simulation& simulation) {
  const auto crossings = scene_crossings(simulation.now().state.configuration.positions,
                                         simulation.built().faces, simulation.built().bodies);
  return crossings ? std::optional(static_cast<int>(crossings->count())) : std::nullopt;
}

// Of solids.
int element_count(const SceneSystem& built) {
  int count = 0;
  for (const SolidPiece& solid : built.solids) count += solid.mesh.element_count();
  return count;
}

std::string obstacles_path(const Scene& scene) {
  if (scene.obstacles.empty()) return {};
  return has_moving_obstacles(scene.obstacles) ? "obstacles" : "obstacles.obj";
}

Json or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json statistics_json(const StepStatistics& numbers) {
  if (!numbers.median) return nullptr;
  return {{"min", or_null(numbers.min)},
          {"median", or_null(numbers.median)},
          {"mean", or_null(numbers.mean)},
          {"max", or_null(numbers.max)}};
}

// The least and the largest of whole numbers are whole.
Json counts_json(const StepStatistics& numbers) {
  Json json = statistics_json(numbers);
  if (numbers.min) json["min"] = static_cast<long>(*numbers.min);
  if (numbers.max) json["max"] = static_cast<long>(*numbers.max);
  return json;
}

Json phases_json(const SimulationResult& result) {
  Json json = Json::object();
  for (const auto& [name, seconds] : result.phases) json[name] = statistics_json(seconds);
  return json;
}

Json frames_json(const SimulationResult& result) {
  Json list = Json::array();
  for (const double time : result.frame_times) {
    list.push_back({{"index", list.size()}, {"time", time}});
  }
  return list;
}

// `time_step` stands beside it.
Json method_json(const SimulationMethod& method) {
  return {{"kind", method.kind},
          {"integrator", or_null(method.integrator)},
          {"solve", method.solve},
          {"tolerance", or_null(method.tolerance)},
          {"motion_tolerance", or_null(method.motion_tolerance)},
          {"linear_tolerance", or_null(method.linear_tolerance)},
          {"adaptive", method.adaptive},
          {"friction", method.friction}};
}

StepStatistics read_statistics(const JsonObject& json, std::string_view key) {
  const std::optional<JsonObject> numbers = json.object(key);
  if (!numbers) return {};
  return {numbers->number("min"), numbers->number("median"), numbers->number("mean"),
          numbers->number("max")};
}

SimulationMethod read_method(const JsonObject& json) {
  const std::optional<JsonObject> method = json.object("method");
  if (!method) return {};
  return {method->text_or("kind", ""),        method->text_or("integrator", ""),
          method->text_or("solve", ""),       method->text_or("friction", ""),
          method->number("tolerance"),        method->number("motion_tolerance"),
          method->number("linear_tolerance"), method->flag_or("adaptive", false)};
}

void read_statistics(const JsonObject& json, SimulationResult& r) {
  r.seconds = read_statistics(json, "seconds_per_step");
  if (const auto phases = json.object("seconds_by_phase")) {
    for (const auto& phase : kPhases) {
      r.phases.emplace_back(phase.first, read_statistics(*phases, phase.first));
    }
  }
  r.substeps = read_statistics(json, "substeps");
  r.newton_iterations = read_statistics(json, "newton_iterations");
  r.linear_iterations = read_statistics(json, "linear_iterations");
  r.contacts = read_statistics(json, "contacts");
  r.contact_distance = read_statistics(json, "contact_distance");
  r.way_tests = read_statistics(json, "way_tests");
}

/// `converged to 10 uN`
std::string solution_text(const SimulationMethod& method) {
  if (method.solve == "linearized") {
    return "one linear system a step, solved to " +
           format_number(method.linear_tolerance.value_or(0), 2);
  }
  if (method.solve == "iterated") {
    return "at most three iterations a step, until nothing moves by more than " +
           format_quantity(method.motion_tolerance.value_or(0), Dimension::length, 2);
  }
  if (!method.tolerance) return "converged";
  return "converged to " + format_quantity(*method.tolerance, Dimension::force, 2);
}

}  // namespace

SimulationResult simulation_result(const Simulation& simulation, const SimulationFacts& facts) {
  const Scene& scene = simulation.scene();
  const SimulationState& now = simulation.now();
  SimulationResult r;
  r.name = scene.name;
  r.info = scene.info;
  r.facts = facts;
  r.scene = scene.file;
  r.finished = simulation.is_finished();
  r.triangles = static_cast<int>(simulation.built().faces.cols());
  r.vertices = simulation.built().vertices;
  r.elements = element_count(simulation.built());
  r.steps = now.steps;
  r.time_step = scene.time.step;
  r.method = method_of(scene.time);
  for (const EnergyRow& row : now.energies) r.frame_times.push_back(row.time);
  r.fields = frame_fields(simulation);
  r.seconds = statistics(now.records.seconds);
  r.phases = phases_of(now.records);
  r.substeps = statistics(now.records.substeps);
  r.newton_iterations = statistics(now.records.newton_iterations);
  r.linear_iterations = statistics(now.records.linear_iterations);
  r.not_modelled = not_modelled(scene);
  r.crossing_pairs = crossing_pairs(simulation);
  r.contacts = statistics(now.records.contacts);
  r.contact_distance = statistics(contact_distances(now.records));
  r.min_contact_distance = r.contact_distance.min;
  if (!now.records.contacts.empty()) r.way_tests = of_steps(now.records, &SearchCosts::way_tests);
  if (scene.solids.empty()) r.mesh = "cloth.obj";
  r.obstacles = obstacles_path(scene);
  if (!scene.solids.empty()) r.solids = "solids.vtu";
  r.energy = "energy.csv";
  if (!scene.clips.empty()) r.clips = "clips.csv";
  r.warnings = simulation.built().warnings;
  return r;
}

std::string simulation_text(const SimulationResult& result) {
  const SimulationFacts& facts = result.facts;
  const Json json{
      {"pliant", kSimulationDocument},
      {"name", result.name},
      {"info", result.info},
      {"command", facts.command},
      {"created", facts.created},
      {"version", facts.version},
      {"scene", result.scene},
      {"scene_sha256", facts.scene_sha256},
      {"threads", facts.threads},
      {"finished", result.finished},
      {"triangles", result.triangles},
      {"vertices", result.vertices},
      {"elements", result.elements},
      {"steps", result.steps},
      {"time_step", result.time_step},
      {"method", method_json(result.method)},
      {"frames", frames_json(result)},
      {"fields", result.fields},
      {"seconds_per_step", statistics_json(result.seconds)},
      {"seconds_by_phase", phases_json(result)},
      {"substeps", counts_json(result.substeps)},
      {"newton_iterations", counts_json(result.newton_iterations)},
      {"linear_iterations", counts_json(result.linear_iterations)},
      {"peak_memory_MB", or_null(facts.peak_memory)},
      {"not_modelled", result.not_modelled},
      {"crossing_pairs", result.crossing_pairs ? Json(*result.crossing_pairs) : Json(nullptr)},
      {"contacts", counts_json(result.contacts)},
      {"contact_distance", statistics_json(result.contact_distance)},
      {"min_contact_distance", or_null(result.min_contact_distance)},
      {"way_tests", counts_json(result.way_tests)},
      {"mesh", or_null(result.mesh)},
      {"obstacles", or_null(result.obstacles)},
      {"solids", or_null(result.solids)},
      {"energy", or_null(result.energy)},
      {"clips", or_null(result.clips)},
      {"warnings", result.warnings}};
  return json.dump(2) + "\n";
}

SimulationResult read_simulation_result(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "simulation.json";
  const nlohmann::json document = read_json_file(file);
  const JsonObject json(document, file.string(), "");
  const std::string type = json.text("pliant");
  if (type != kSimulationDocument) {
    json.fail("pliant", "unknown document `" + type + "`", kSimulationDocument);
  }
  SimulationResult r;
  r.name = json.text_or("name", "unnamed");
  r.info = json.entries("info");
  r.facts = {json.text_or("command", ""),   json.text_or("created", ""),
             json.text_or("version", ""),   json.text_or("scene_sha256", ""),
             json.integer_or("threads", 0), json.number("peak_memory_MB")};
  r.scene = json.text_or("scene", "");
  r.finished = json.flag_or("finished", true);
  r.triangles = json.integer_or("triangles", 0);
  r.vertices = json.integer_or("vertices", 0);
  r.elements = json.integer_or("elements", 0);
  r.steps = json.integer_or("steps", 0);
  r.time_step = json.number("time_step").value_or(0);
  r.method = read_method(json);
  for (const JsonObject& frame : json.objects("frames")) {
    r.frame_times.push_back(frame.number("time").value_or(0));
  }
  r.fields = json.entries("fields");
  read_statistics(json, r);
  r.not_modelled = json.texts("not_modelled");
  if (json.has("crossing_pairs")) r.crossing_pairs = json.integer_or("crossing_pairs", 0);
  r.min_contact_distance = json.number("min_contact_distance");
  r.mesh = json.relative_file_or("mesh", "");
  r.obstacles = json.relative_file_or("obstacles", "");
  r.solids = json.relative_file_or("solids", "");
  r.energy = json.relative_file_or("energy", "");
  r.clips = json.relative_file_or("clips", "");
  r.warnings = json.texts("warnings");
  return r;
}

std::string method_text(const SimulationMethod& method) {
  std::vector<std::string> parts;
  if (method.kind == "quasi-static") parts.emplace_back("path of equilibria");
  if (method.integrator == "backward-euler") parts.emplace_back("backward Euler");
  if (method.integrator == "bdf2") parts.emplace_back("BDF2");
  if (!method.solve.empty()) parts.push_back(solution_text(method));
  if (!method.friction.empty()) {
    parts.push_back(method.friction == "none" ? "no friction" : method.friction + " friction");
  }
  if (method.adaptive) parts.emplace_back("steps halved where they fail");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string limits_text(const SimulationResult& result) {
  std::string text;
  if (!result.not_modelled.empty()) {
    text = fmt::format("Not modelled: {}. ", fmt::join(result.not_modelled, ", "));
  }
  if (!result.crossing_pairs) return std::string(trimmed(text));
  const int pairs = *result.crossing_pairs;
  const std::string crossing =
      pairs == 0 ? "no triangles"
                 : fmt::format("{} pair{} of triangles", pairs, pairs == 1 ? "" : "s");
  return fmt::format("{}{} {} pass through each other.", text,
                     result.finished ? "At the end" : "At the last step", crossing);
}

}  // namespace pliant
