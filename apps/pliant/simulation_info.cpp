#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/report/simulation_results.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

void describe(const report::SimulationResults& results, FileInfo& info) {
  const std::string method = report::method_text(results.method);
  info.json["name"] = results.name;
  info.json["created"] = results.created;
  info.json["version"] = results.version;
  info.json["command"] = results.command;
  info.json["scene"] = results.scene;
  info.json["finished"] = results.finished;
  info.json["triangles"] = results.triangles;
  info.json["vertices"] = results.vertices;
  info.json["steps"] = results.steps;
  info.json["time_step"] = results.time_step;
  info.json["method"] = method;
  info.json["frames"] = results.frames;
  info.json["last_time"] = results.last_time;
  info.lines.push_back(labelled("name", results.name));
  info.lines.push_back(labelled("made", fmt::format("{} by version {}: {}", results.created,
                                                    results.version, results.command)));
  info.lines.push_back(
      labelled("finished", results.finished ? "yes" : "no: `pliant simulate --resume` goes on"));
  info.lines.push_back(labelled(
      "mesh", fmt::format("{} vertices, {} triangles", results.vertices, results.triangles)));
  info.lines.push_back(labelled(
      "steps",
      fmt::format("{} of {} s", results.steps, format_number(results.time_step, kInfoDigits))));
  if (!method.empty()) info.lines.push_back(labelled("method", method));
  info.lines.push_back(
      labelled("frames", fmt::format("{}, up to {} s", results.frames,
                                     format_number(results.last_time, kInfoDigits))));
  const std::string limits = report::limits_text(results);
  info.json["not_modelled"] = results.not_modelled;
  info.json["crossing_pairs"] = nullptr;
  if (results.crossing_pairs) info.json["crossing_pairs"] = *results.crossing_pairs;
  if (!limits.empty()) info.lines.push_back(labelled("limits", limits));
  info.warnings = results.warnings;
}

}  // namespace

FileInfo simulation_info(const std::filesystem::path& path) {
  const bool directory = std::filesystem::is_directory(path);
  if (!directory && path.filename() != "simulation.json") {
    throw InputError({path.string(), 0, ""}, "results under another name",
                     "simulation.json in a directory of its own, as the program writes it");
  }
  const report::SimulationResults results = report::read_simulation_results(
      directory ? path : std::filesystem::absolute(path).parent_path());
  FileInfo info = begin_info(path, directory ? "simulation/1 results" : "simulation/1");
  describe(results, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
