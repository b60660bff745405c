#include "pliant/report/simulation_results.h"

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/report/json_reader.h"

namespace pliant::report {
namespace {

StepStatistics read_statistics(const JsonReader& json, std::string_view key) {
  const std::optional<JsonReader> numbers = json.object(key);
  if (!numbers) return {};
  return {numbers->number("min"), numbers->number("median"), numbers->number("mean"),
          numbers->number("max")};
}

EnergyTable read_energy(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  return {table.numbers("time_s"), table.numbers("kinetic_J"), table.numbers("stored_J"),
          table.numbers("work_J")};
}

void read_frames(const JsonReader& json, SimulationResults& results) {
  const std::vector<JsonReader> frames = json.objects("frames");
  results.frames = frames.size();
  if (!frames.empty()) results.last_time = frames.back().number("time").value_or(0);
}

}  // namespace

SimulationResults read_simulation_results(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "simulation.json";
  const nlohmann::json document = read_json_file(file);
  const JsonReader json(document, file.string(), "");
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
  read_frames(json, r);
  r.seconds = read_statistics(json, "seconds_per_step");
  r.newton_iterations = read_statistics(json, "newton_iterations");
  r.linear_iterations = read_statistics(json, "linear_iterations");
  r.peak_memory = json.number("peak_memory_MB");
  r.min_contact_distance = json.number("min_contact_distance");
  r.energy_file = json.relative_file_or("energy", "");
  if (!r.energy_file.empty()) r.energy = read_energy(directory / r.energy_file);
  r.warnings = json.texts("warnings");
  return r;
}

}  // namespace pliant::report
