#include "pliant/report/simulation_results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/io/csv.h"
#include "pliant/io/json_object.h"

namespace pliant::report {
namespace {

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

EnergyTable read_energy(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  EnergyTable energy{table.numbers("time_s"),
                     table.numbers("kinetic_J"),
                     table.numbers("stored_J"),
                     table.numbers("work_J"),
                     {},
                     {}};
  const auto later = [&](const char* column) {
    return table.has(column) ? table.numbers(column) : std::vector<double>(energy.rows(), 0.0);
  };
  energy.drag = later("drag_J");
  energy.outside = later("outside_J");
  return energy;
}

void read_phases(const JsonObject& json, SimulationResults& results) {
  const std::optional<JsonObject> phases = json.object("seconds_by_phase");
  if (!phases) return;
  const std::pair<const char*, const char*> known[] = {
      {"assembly", "forces and Hessians"},       {"equations", "linear equations"},
      {"energies", "energies along the search"}, {"pairs", "search for what is near"},
      {"ways", "how far vertices may go"},       {"history", "what is remembered of it"}};
  for (const auto& [key, words] : known) {
    results.phases.emplace_back(words, read_statistics(*phases, key));
  }
}

void read_frames(const JsonObject& json, SimulationResults& results) {
  const std::vector<JsonObject> frames = json.objects("frames");
  results.frames = frames.size();
  if (!frames.empty()) results.last_time = frames.back().number("time").value_or(0);
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

std::string limits_text(const SimulationResults& results) {
  std::string text;
  if (!results.not_modelled.empty()) {
    text = fmt::format("Not modelled: {}. ", fmt::join(results.not_modelled, ", "));
  }
  if (!results.crossing_pairs) return std::string(trimmed(text));
  const int pairs = *results.crossing_pairs;
  const std::string crossing =
      pairs == 0 ? "no triangles"
                 : fmt::format("{} pair{} of triangles", pairs, pairs == 1 ? "" : "s");
  return fmt::format("{}{} {} pass through each other.", text,
                     results.finished ? "At the end" : "At the last step", crossing);
}

SimulationResults read_simulation_results(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "simulation.json";
  const nlohmann::json document = read_json_file(file);
  const JsonObject json(document, file.string(), "");
  const std::string type = json.text("pliant");
  if (type != "simulation/1") {
    json.fail("pliant", "unknown document `" + type + "`", "simulation/1");
  }
  SimulationResults r;
  r.name = json.text_or("name", "unnamed");
  r.command = json.text_or("command", "");
  r.created = json.text_or("created", "");
  r.version = json.text_or("version", "");
  r.scene = json.text_or("scene", "");
  r.scene_sha256 = json.text_or("scene_sha256", "");
  r.info = json.entries("info");
  r.finished = json.flag_or("finished", true);
  r.triangles = json.integer_or("triangles", 0);
  r.vertices = json.integer_or("vertices", 0);
  r.steps = json.integer_or("steps", 0);
  r.threads = json.integer_or("threads", 0);
  r.time_step = json.number("time_step").value_or(0);
  r.method = read_method(json);
  read_frames(json, r);
  r.seconds = read_statistics(json, "seconds_per_step");
  read_phases(json, r);
  r.substeps = read_statistics(json, "substeps");
  r.contacts = read_statistics(json, "contacts");
  r.contact_distance = read_statistics(json, "contact_distance");
  r.way_tests = read_statistics(json, "way_tests");
  r.newton_iterations = read_statistics(json, "newton_iterations");
  r.linear_iterations = read_statistics(json, "linear_iterations");
  r.peak_memory = json.number("peak_memory_MB");
  r.min_contact_distance = json.number("min_contact_distance");
  r.energy_file = json.relative_file_or("energy", "");
  if (!r.energy_file.empty()) r.energy = read_energy(directory / r.energy_file);
  r.warnings = json.texts("warnings");
  r.not_modelled = json.texts("not_modelled");
  if (json.number("crossing_pairs")) r.crossing_pairs = json.integer_or("crossing_pairs", 0);
  return r;
}

}  // namespace pliant::report
