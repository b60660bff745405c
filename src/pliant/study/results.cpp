#include "pliant/study/results.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/experiment/registry.h"
#include "pliant/io/json_object.h"
#include "pliant/material/material.h"

namespace pliant {
namespace {

std::filesystem::path results_file(const std::filesystem::path& directory) {
  for (const char* name : {"fit.json", "evaluation.json"}) {
    if (std::filesystem::exists(directory / name)) return directory / name;
  }
  throw InputError({directory.string(), 0, {}}, "no results of fit, evaluate or simulate",
                   "a directory with fit.json, evaluation.json, summary.json or simulation.json");
}

/// `stretch.warp` of `stretch.warp.friction.a` or `stretch.warp.k[2]`; empty for numbers of none.
std::string component_of(const std::string& parameter) {
  for (const MaterialKind kind : {MaterialKind::cloth, MaterialKind::solid}) {
    for (const std::string& name : component_names(kind)) {
      if (parameter.starts_with(name + ".")) return name;
    }
  }
  return {};
}

ResultParameter read_parameter(const JsonObject& json) {
  ResultParameter p;
  p.name = json.text("name");
  p.component = json.text_or("component", component_of(p.name));
  p.experiment = json.text_or("experiment", "");
  p.unit = json.text_or("unit", "");
  p.note = json.text_or("note", "");
  p.value = json.number("value");
  p.std_error = json.number("std_error");
  p.lower = json.number("lower");
  p.upper = json.number("upper");
  p.between_specimen_sd = json.number("between_specimen_sd");
  p.identified = json.flag_or("identified", true);
  p.at_bound = json.flag_or("at_bound", false);
  p.fixed = json.flag_or("fixed", false);
  return p;
}

DataFile read_data(const JsonObject& json) {
  return {json.text("experiment"), json.text("file"), json.text("sha256")};
}

std::optional<MembraneMeasure> read_membrane(const JsonObject& json) {
  if (!json.has("membrane")) return std::nullopt;
  const std::string name = json.text("membrane");
  const MembraneMeasure measure = membrane_measure(name);
  if (name != name_of(measure)) {
    json.fail("membrane", "unknown measure `" + name + "`", "stvk, soft-constraint or spring");
  }
  return measure;
}

ResultFigure read_figure(const JsonObject& json) {
  return {json.text("component"), json.text("name"),    json.text("unit"),
          json.number("value"),   json.number("at"),    json.number("std_error"),
          json.number("lower"),   json.number("upper"), json.flag_or("beyond_range", false)};
}

std::string read_skipped(const JsonObject& json) {
  return fmt::format("{}: the material has no {}", json.text("name"),
                     fmt::join(json.texts("missing"), ", "));
}

std::optional<LoopMeasures> read_loop(const std::optional<JsonObject>& json) {
  if (!json) return std::nullopt;
  return LoopMeasures{json->number("secant_modulus_N_per_m"), json->number("secant_rigidity_N_m"),
                      json->number("hysteresis_ratio"), json->number("loop_loss")};
}

std::optional<ResultNoise> read_noise(const std::optional<JsonObject>& json) {
  if (!json || !json->has("value")) return std::nullopt;
  return ResultNoise{json->text_or("quantity", "noise"), json->text_or("unit", ""),
                     json->text_or("source", ""), *json->number("value"), json->number("floor")};
}

std::optional<std::array<double, 2>> read_range(const JsonObject& json, std::string_view key) {
  const std::vector<double> range = json.numbers(key);
  if (range.empty()) return std::nullopt;
  if (range.size() != 2) json.fail(key, "not a range", "two numbers");
  return std::array{range[0], range[1]};
}

/// Pairs of a row, from 1, and how far it is off.
std::vector<std::size_t> read_outliers(const JsonObject& json) {
  std::vector<std::size_t> rows;
  for (const std::vector<double>& outlier : json.number_rows("outliers")) {
    if (outlier.size() != 2 || !(outlier[0] >= 1)) {
      json.fail("outliers", "not a row and how far it is off", "two numbers each");
    }
    rows.push_back(static_cast<std::size_t>(outlier[0]) - 1);
  }
  return rows;
}

template <typename Item>
std::vector<Item> read_all(const JsonObject& json, std::string_view key,
                           Item (*read)(const JsonObject&)) {
  std::vector<Item> items;
  for (const JsonObject& object : json.objects(key)) items.push_back(read(object));
  return items;
}

ResultLoopFigure read_loop_figure(const JsonObject& json) {
  return {json.text("name"), json.number("measured"), json.number("predicted")};
}

ResultExperiment read_experiment(const JsonObject& json) {
  ResultExperiment e;
  e.name = json.text("name");
  e.type = json.text_or("type", "");
  e.direction = json.text_or("direction", "");
  e.component = json.text_or("component", e.name);
  e.quantity = json.text_or("quantity", "force_N");
  e.prediction_file = json.relative_file_or("prediction_file", "predictions/" + e.name + ".csv");
  e.validation = json.text_or("role", "fit") == "validate";
  const bool stress = e.quantity.ends_with("_Pa");
  e.rms_force = json.number(stress ? "rms_stress_Pa" : "rms_force_N");
  e.peak_force = json.number(stress ? "peak_stress_Pa" : "peak_force_N");
  e.rms_percent_of_peak = json.number("rms_percent_of_peak");
  e.rms_elastic_percent_of_peak = json.number("rms_elastic_percent_of_peak");
  e.rms_limp_percent_of_peak = json.number("rms_limp_percent_of_peak");
  e.rms_position_mm = json.number("rms_position_mm");
  e.rms_elastic_position_mm = json.number("rms_elastic_position_mm");
  e.rms_percent_of_length = json.number("rms_percent_of_length");
  e.fold_height_error_mm = json.number("fold_height_error_mm");
  e.points = json.integer_or("points", 0);
  e.specimens = json.integer_or("specimens", 0);
  e.excluded = json.integer_or("excluded", 0);
  e.noise = read_noise(json.object("noise"));
  e.strain_range = read_range(json, "strain_range");
  if (const auto loop = json.object("loop")) {
    e.measured_loop = read_loop(loop->object("measured"));
    e.predicted_loop = read_loop(loop->object("predicted"));
  }
  e.figures = read_all(json, "figures", read_loop_figure);
  e.unloads = json.flag_or("unloads", false);
  if (json.has("shape_file")) e.shape_file = json.relative_file_or("shape_file", "");
  if (json.has("sheets")) e.sheet_folder = json.relative_file_or("sheets", "");
  e.outliers = read_outliers(json);
  e.handled = json.texts("handled");
  return e;
}

ResultWholeSheet read_whole_sheet(const JsonObject& json) {
  ResultWholeSheet whole;
  whole.name = json.text("name");
  whole.type = json.text_or("type", "");
  whole.unit = json.text_or("unit", "");
  if (json.has("picture_file")) whole.picture_file = json.relative_file_or("picture_file", "");
  whole.measured_mean = json.number("measured_mean");
  whole.predicted_mean = json.number("predicted_mean");
  whole.rms = json.number("rms");
  whole.points = json.integer_or("points", 0);
  whole.told = json.texts("told");
  whole.handled = json.texts("handled");
  return whole;
}

// JSON knows no NaN: null is an unknown number.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double number_of(const JsonObject& json, std::string_view key) {
  return json.number(key).value_or(kUnknown);
}

FitStage read_stage(const JsonObject& json) {
  return {json.text_or("component", ""), json.text_or("name", ""),       json.text_or("unit", ""),
          number_of(json, "rms"),        json.flag_or("accepted", true), json.text_or("ended", "")};
}

std::optional<EquilibriumWork> read_work(const std::optional<JsonObject>& json) {
  if (!json) return std::nullopt;
  EquilibriumWork work;
  EquilibriumCounts& counts = work.counts;
  counts.equilibria = json->integer_or("equilibria", 0);
  counts.iterations = json->integer_or("newton_iterations", 0);
  counts.factors = json->integer_or("factorizations", 0);
  counts.differentiated = json->integer_or("differentiated", 0);
  counts.differences = json->integer_or("equilibria_by_differences", 0) - counts.equilibria;
  if (const auto seconds = json->object("seconds")) {
    work.seconds = {seconds->number("equilibria").value_or(0),
                    seconds->number("derivatives").value_or(0)};
  }
  return work;
}

StartRecord read_start(const JsonObject& json) {
  StartRecord start{json.text_or("component", ""),           json.text_or("search", "law"),
                    json.text_or("unit", "times the noise"), json.numbers("ends"),
                    json.integer_or("reached_best", 0),      json.flag_or("followed", true)};
  // Earlier versions did not say where each had led.
  const auto tried = static_cast<std::size_t>(json.integer_or("tried", 0));
  start.ends.resize(std::max(tried, start.ends.size()), kUnknown);
  return start;
}

ModelRank read_model(const JsonObject& json) {
  return {json.text_or("component", ""),    json.text_or("name", ""),
          json.integer_or("parameters", 0), number_of(json, "rms_percent_of_peak"),
          number_of(json, "aic"),           number_of(json, "bic"),
          number_of(json, "delta_bic"),     json.text_or("told_by", "")};
}

Profile read_profile(const JsonObject& json) {
  Profile profile{json.text("parameter"),     json.text_or("unit", ""), json.numbers("value"),
                  json.numbers("delta_chi2"), json.number("lower"),     json.number("upper"),
                  json.number("std_error")};
  if (profile.value.size() != profile.delta_chi2.size()) {
    json.fail("delta_chi2", "not as long as `value`", "one number a value");
  }
  return profile;
}

ResultJudgement read_judgement(const std::optional<JsonObject>& json) {
  ResultJudgement judgement;
  if (!json) return judgement;
  judgement.fitness = json->text("fitness");
  judgement.headline = json->text("headline");
  judgement.details = json->text_or("details", "");
  judgement.undetermined = json->texts("undetermined");
  for (const JsonObject& e : json->objects("experiments")) {
    if (e.text("fitness") != "fit") judgement.misses.push_back(e.text("name"));
  }
  for (const JsonObject& c : json->objects("criteria")) {
    judgement.criteria.push_back(c.text("text"));
  }
  return judgement;
}

/// A nuisance parameter goes with the component that its experiment measures.
void assign_nuisance_components(Results& results) {
  for (ResultParameter& p : results.nuisance) {
    for (const ResultExperiment& e : results.experiments) {
      if (e.name == p.experiment) p.component = e.component;
    }
  }
}

void check_covariance(const JsonObject& json, const Results& results) {
  if (results.covariance.empty()) return;
  const std::size_t n = results.parameters.size() + results.nuisance.size();
  bool square = results.covariance.size() == n;
  for (const auto& row : results.covariance) square = square && row.size() == n;
  if (!square) {
    json.fail("covariance", "wrong size", fmt::format("{0} rows of {0} numbers", n));
  }
}

}  // namespace

Results read_results(const std::filesystem::path& directory) {
  const std::string file = results_file(directory).string();
  const nlohmann::json document = read_json_file(file);
  const JsonObject json(document, file, "");
  const std::string type = json.text("pliant");
  if (type != "fit/1" && type != "evaluation/1") {
    json.fail("pliant", "unknown document `" + type + "`", "fit/1 or evaluation/1");
  }
  Results r;
  r.evaluation = type == "evaluation/1";
  r.name = json.text_or("name", "unnamed");
  r.facts = {json.text_or("command", ""),      json.text_or("created", ""),
             json.text_or("version", ""),      json.text_or("study", ""),
             json.text_or("study_sha256", ""), json.text_or("material", "")};
  r.estimator = json.text_or("estimator", "");
  r.data = read_all(json, "data", read_data);
  r.density = json.number("density");
  r.seconds = json.number("seconds");
  r.membrane = read_membrane(json);
  r.figures = read_all(json, "figures", read_figure);
  r.converged = json.flag_or("converged", true);
  r.info = json.entries("info");
  r.conditions = json.entries("conditions");
  r.parameters = read_all(json, "parameters", read_parameter);
  r.nuisance = read_all(json, "nuisance", read_parameter);
  r.covariance = json.number_rows("covariance");
  check_covariance(json, r);
  for (const JsonObject& one : json.objects("singular_values")) {
    r.singular_values[one.text_or("component", "")] = one.numbers("values");
  }
  r.experiments = read_all(json, "experiments", read_experiment);
  r.whole_sheets = read_all(json, "whole_sheets", read_whole_sheet);
  assign_nuisance_components(r);
  r.work = read_work(json.object("work"));
  r.stages = read_all(json, "stages", read_stage);
  r.starts = read_all(json, "starts", read_start);
  r.models = read_all(json, "models", read_model);
  r.profiles = read_all(json, "profiles", read_profile);
  r.judgement = read_judgement(json.object("judgement"));
  // Earlier versions did not judge them.
  if (r.judgement.undetermined.empty()) r.judgement.undetermined = json.texts("undetermined");
  r.assumptions = json.texts("assumptions");
  r.warnings = json.texts("warnings");
  r.questions = json.texts("questions");
  r.skipped = read_all(json, "skipped", read_skipped);
  return r;
}

bool Results::is_of_solid() const {
  return std::ranges::any_of(
      experiments, [](const ResultExperiment& e) { return facts_of_test(e.type).measures_solids; });
}

bool Results::has_samples() const {
  return std::ranges::any_of(
      parameters, [](const ResultParameter& p) { return p.name.starts_with(kOfSample); });
}

bool Results::differs_in(const std::string& component) const {
  return std::ranges::any_of(parameters, [&](const ResultParameter& p) {
    return p.component == component && p.name.starts_with(kOfSample);
  });
}

bool Results::has_figures(const std::string& component) const {
  return std::ranges::find(figures, component, &ResultFigure::component) != figures.end();
}

}  // namespace pliant
