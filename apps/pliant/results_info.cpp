#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/result_manifest.h"
#include "pliant/material/material_file.h"
#include "pliant/report/report_data.h"
#include "pliant/study/results.h"
#include "pliant/study/study.h"

#include "apps/pliant/file_info.h"
#include "apps/pliant/given_document.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::string number_text(const std::optional<double>& value) {
  return value ? format_number(*value, kInfoDigits) : "unknown";
}

std::string uncertainty_text(const ResultParameter& parameter) {
  if (parameter.fixed) return "fixed";
  if (parameter.at_bound) return "at its bound";
  if (!parameter.identified) return "not determined by the data";
  if (parameter.lower && parameter.upper) {
    return fmt::format("95 %: {} to {}", format_number(*parameter.lower, kInfoDigits),
                       format_number(*parameter.upper, kInfoDigits));
  }
  return "no standard error";
}

void add_parameter(const ResultParameter& parameter, FileInfo& info) {
  info.json["parameters"].push_back({{"name", parameter.name},
                                     {"value", or_null(parameter.value)},
                                     {"unit", parameter.unit},
                                     {"std_error", or_null(parameter.std_error)},
                                     {"identified", parameter.identified}});
  const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
  info.lines.push_back(labelled(
      parameter.name,
      fmt::format("{}{} ({})", number_text(parameter.value), unit, uncertainty_text(parameter)),
      1));
}

std::string error_text(const ResultExperiment& experiment) {
  if (experiment.rms_percent_of_length) {
    return fmt::format("{} mm, {} % of the strip's length", number_text(experiment.rms_position_mm),
                       number_text(experiment.rms_percent_of_length));
  }
  return fmt::format("{} % of the largest {}", number_text(experiment.rms_percent_of_peak),
                     experiment.measures_lengths() ? "extension" : "force");
}

void add_experiment(const ResultExperiment& experiment, FileInfo& info) {
  info.json["experiments"].push_back(
      {{"name", experiment.name},
       {"type", experiment.type},
       {"role", experiment.validation ? "validate" : "fit"},
       {"points", experiment.points},
       {"specimens", experiment.specimens},
       {"rms_percent_of_peak", or_null(experiment.rms_percent_of_peak)},
       {"rms_percent_of_length", or_null(experiment.rms_percent_of_length)}});
  info.lines.push_back(labelled(experiment.name,
                                fmt::format("{}, {}: error {}; {} rows", experiment.type,
                                            experiment.validation ? "predicted" : "fitted",
                                            error_text(experiment), experiment.points),
                                1));
}

void describe_results(const Results& results, FileInfo& info) {
  info.json["name"] = results.name;
  info.json["created"] = results.facts.created;
  info.json["version"] = results.facts.version;
  info.json["command"] = results.facts.command;
  info.json["converged"] = results.converged;
  info.json["parameters"] = Json::array();
  info.json["experiments"] = Json::array();
  info.json["undetermined"] = results.judgement.undetermined;
  info.lines.push_back(labelled("name", results.name));
  info.lines.push_back(labelled("made", fmt::format("{} by version {}: {}", results.facts.created,
                                                    results.facts.version, results.facts.command)));
  if (!results.evaluation) {
    info.lines.push_back(labelled("estimator", results.estimator));
    info.lines.push_back(labelled("converged", results.converged ? "yes" : "no"));
    info.lines.push_back(labelled("parameters", fmt::format("{}", results.parameters.size())));
  } else {
    info.lines.push_back(labelled("material", results.facts.material_file));
  }
  for (const ResultParameter& parameter : results.parameters) add_parameter(parameter, info);
  info.lines.push_back(labelled("experiments", fmt::format("{}", results.experiments.size())));
  for (const ResultExperiment& experiment : results.experiments) {
    add_experiment(experiment, info);
  }
  for (const std::string& text : results.judgement.undetermined) {
    info.lines.push_back(labelled("not determined", text));
  }
  info.warnings = results.warnings;
}

std::string type_of(const Results& results) {
  return results.evaluation ? "evaluation/1" : "fit/1";
}

/// Results are read by their directory, where a file's name tells what it is.
void require_usual_name(const fs::path& path) {
  const std::string name = path.filename().string();
  const bool shadowed = name == "evaluation.json" && fs::exists(path.parent_path() / "fit.json");
  if ((name == "fit.json" || name == "evaluation.json") && !shadowed) return;
  throw InputError(
      {path.string(), 0, ""}, "results under another name, or beside others",
      "fit.json or evaluation.json in a directory of its own, as the program writes it");
}

/// Every file that the command wrote is still there.
void refuse_missing_files(const fs::path& directory, const ResultManifest& manifest) {
  for (const std::string& file : manifest.files) {
    if (fs::exists(directory / file)) continue;
    throw InputError({(directory / file).string(), 0, ""}, "is missing",
                     fmt::format("the file that `{}` wrote", manifest.command));
  }
}

void add_manifest(const ResultManifest& manifest, FileInfo& info) {
  info.json["made_by"] = manifest.command;
  info.json["files"] = manifest.files;
  info.lines.push_back(labelled(
      "files", fmt::format("{}, written by `pliant {}`", manifest.files.size(), manifest.command)));
}

/// Everything that the report is made from, and the documents beside it, are read.
FileInfo results_directory_info(const fs::path& directory) {
  const report::ReportData data = report::read_report_data(directory);
  if (fs::exists(directory / "material.json")) read_material(directory / "material.json");
  if (fs::exists(directory / "study.resolved.yaml")) read_study(directory / "study.resolved.yaml");
  FileInfo info = begin_info(directory, type_of(data.results) + " results");
  describe_results(data.results, info);
  return info;
}

}  // namespace

FileInfo results_file_info(const fs::path& path) {
  require_usual_name(path);
  const Results results = read_results(fs::absolute(path).parent_path());
  FileInfo info = begin_info(path, type_of(results));
  describe_results(results, info);
  info.json["warnings"] = info.warnings;
  return info;
}

FileInfo directory_info(const fs::path& path) {
  const std::optional<ResultManifest> manifest = read_manifest(path);
  const bool results = fs::exists(path / "fit.json") || fs::exists(path / "evaluation.json");
  const bool fitted = manifest && (manifest->command == "fit" || manifest->command == "evaluate");
  if (manifest) refuse_missing_files(path, *manifest);
  const bool simulated = fs::exists(path / "simulation.json");
  const bool measured = fs::exists(path / "session.yaml");
  FileInfo info = results || fitted ? results_directory_info(path)
                  : simulated       ? simulation_info(path)
                  : measured        ? session_info(path)
                                    : study_info(given_document(path, "study"));
  if (manifest) add_manifest(*manifest, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
