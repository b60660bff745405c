#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/scene/simulation_result.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

void describe(const SimulationResult& result, FileInfo& info) {
  const std::string method = method_text(result.method);
  info.json["name"] = result.name;
  info.json["created"] = result.facts.created;
  info.json["version"] = result.facts.version;
  info.json["command"] = result.facts.command;
  info.json["scene"] = result.scene;
  info.json["finished"] = result.finished;
  info.json["triangles"] = result.triangles;
  info.json["vertices"] = result.vertices;
  info.json["steps"] = result.steps;
  info.json["time_step"] = result.time_step;
  info.json["method"] = method;
  info.json["frames"] = result.frame_times.size();
  info.json["last_time"] = result.last_time();
  info.lines.push_back(labelled("name", result.name));
  info.lines.push_back(labelled("made", fmt::format("{} by version {}: {}", result.facts.created,
                                                    result.facts.version, result.facts.command)));
  info.lines.push_back(
      labelled("finished", result.finished ? "yes" : "no: `pliant simulate --resume` goes on"));
  info.lines.push_back(labelled(
      "mesh", fmt::format("{} vertices, {} triangles", result.vertices, result.triangles)));
  info.lines.push_back(labelled(
      "steps",
      fmt::format("{} of {} s", result.steps, format_number(result.time_step, kInfoDigits))));
  if (!method.empty()) info.lines.push_back(labelled("method", method));
  info.lines.push_back(
      labelled("frames", fmt::format("{}, up to {} s", result.frame_times.size(),
                                     format_number(result.last_time(), kInfoDigits))));
  const std::string limits = limits_text(result);
  info.json["not_modelled"] = result.not_modelled;
  info.json["crossing_pairs"] = nullptr;
  if (result.crossing_pairs) info.json["crossing_pairs"] = *result.crossing_pairs;
  if (!limits.empty()) info.lines.push_back(labelled("limits", limits));
  info.warnings = result.warnings;
}

}  // namespace

FileInfo simulation_info(const std::filesystem::path& path) {
  const bool directory = std::filesystem::is_directory(path);
  if (!directory && path.filename() != "simulation.json") {
    throw InputError({path.string(), 0, ""}, "results under another name",
                     "simulation.json in a directory of its own, as the program writes it");
  }
  const std::filesystem::path folder =
      directory ? path : std::filesystem::absolute(path).parent_path();
  const SimulationResult result = read_simulation_result(folder);
  if (!result.energy.empty()) read_energy_table(folder / result.energy);
  FileInfo info = begin_info(path, directory ? "simulation/1 results" : "simulation/1");
  describe(result, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
