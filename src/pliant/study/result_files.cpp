#include "pliant/study/result_files.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "pliant/io/csv_writer.h"
#include "pliant/material/material_file.h"
#include "pliant/study/body_map.h"
#include "pliant/study/figure_files.h"
#include "pliant/study/frame_measure_table.h"
#include "pliant/study/shape_table.h"
#include "pliant/study/whole_sheet_files.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

// JSON knows no NaN: an unknown number is null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json parameter_json(const ParameterEstimate& p, const char* owner) {
  return {{"name", p.name},
          {"value", number(p.value)},
          {"std_error", number(p.std_error)},
          {"unit", p.unit},
          {"identified", p.identified},
          {"at_bound", p.at_bound},
          {"between_specimen_sd", number(p.between_specimen_sd)},
          {"fixed", p.fixed},
          {"lower", number(p.lower)},
          {"upper", number(p.upper)},
          {"determined", name_of(p.determination)},
          {"limit", number(p.limit)},
          {"told_by", p.told_by},
          {"note", p.note},
          {owner, p.owner}};
}

// Moment over curvature is a rigidity, not a modulus, and a contraction has none.
Json loop_json(const LoopMetrics& loop, const ExperimentResult& e) {
  const bool moment = e.quantity.name == "moment_N";
  const bool modulus = !moment && !is_contraction(e.component);
  Json json{{"secant_modulus_N_per_m", modulus ? number(loop.secant_modulus) : Json(nullptr)},
            {"hysteresis_ratio", number(loop.hysteresis_ratio)},
            {"loop_loss", number(loop.loop_loss)}};
  if (moment) json["secant_rigidity_N_m"] = number(loop.secant_modulus);
  return json;
}

std::string prediction_file(const ExperimentResult& e) { return "predictions/" + e.name + ".csv"; }

std::string shape_file(const ExperimentResult& e) { return "shapes/" + e.name + ".csv"; }

/// Only clips have forces to be measured.
bool has_measures(const ExperimentResult& e) { return e.sheet && !e.sheet->measured.clips.empty(); }

std::string measure_file(const ExperimentResult& e) { return "measures/" + e.name + ".csv"; }

std::string sheet_folder(const ExperimentResult& e) { return "sheets/" + e.name; }

// What an error is called depends on what is compared: a distance has no peak, but a strip's length
// that it may be held against.
Json experiment_json(const ExperimentResult& e) {
  const bool distance = e.quantity.kind == "distance";
  const bool length = e.quantity.kind == "length" || distance;
  const bool stress = e.quantity.kind == "stress", reading = e.quantity.kind == "reading";
  const bool force = !distance && !stress && !reading && !is_contraction(e.component);
  Json json{{"name", e.name},
            {"type", e.type},
            {"direction", e.direction},
            {"component", e.component},
            {"role", e.role == ExperimentRole::fit ? "fit" : "validate"},
            {"quantity", e.quantity.name},
            {"rms_force_N", length || stress || reading ? Json(nullptr) : number(e.rms)},
            {"peak_force_N", force ? number(e.peak_force) : Json(nullptr)},
            {"rms_stress_Pa", stress ? number(e.rms) : Json(nullptr)},
            {"peak_stress_Pa", stress ? number(e.peak_force) : Json(nullptr)},
            {"rms_in_sd", reading ? number(e.rms) : Json(nullptr)},
            {"rms_percent_of_peak", distance ? Json(nullptr) : number(e.rms_percent)},
            {"rms_percent_of_length", distance ? number(e.rms_percent) : Json(nullptr)},
            {"rms_position_mm", length ? number(e.rms * 1e3) : Json(nullptr)},
            {"rms_elastic_percent_of_peak", distance ? Json(nullptr) : number(e.elastic_percent)},
            {"rms_elastic_position_mm",
             length && e.elastic_rms ? number(*e.elastic_rms * 1e3) : Json(nullptr)},
            {"rms_limp_percent_of_peak", number(e.limp_percent)},
            {"r_squared", number(e.r_squared)},
            {"points", e.points},
            {"specimens", e.specimens.size()},
            {"excluded", e.excluded},
            {"noise",
             {{"quantity", e.quantity.kind},
              {"value", number(e.noise * e.quantity.per_si)},
              {"unit", e.quantity.unit},
              {"source", e.noise_source}}},
            {"strain_range", {e.strain_range.first, e.strain_range.second}}};
  if (e.role == ExperimentRole::fit) {
    json["noise"]["effective_rows"] = number(e.effective_rows);
    json["outliers"] = Json::array();
    for (const Outlier& outlier : e.outliers) {
      json["outliers"].push_back(Json::array({outlier.row + 1, outlier.in_sd}));
    }
  }
  json["noise"]["floor"] = nullptr;
  if (e.noise_floor) json["noise"]["floor"] = number(*e.noise_floor * e.quantity.per_si);
  json["unloads"] = e.unloads;
  json["loop"] = nullptr;
  if (e.measured_loop && e.predicted_loop) {
    json["loop"] = {{"measured", loop_json(*e.measured_loop, e)},
                    {"predicted", loop_json(*e.predicted_loop, e)}};
  }
  json["figures"] = loop_figures_json(e);
  json["handled"] = e.handled;
  json["prediction_file"] = prediction_file(e);
  json["shape_file"] = e.shapes ? Json(shape_file(e)) : Json(nullptr);
  json["measure_file"] = has_measures(e) ? Json(measure_file(e)) : Json(nullptr);
  json["fold_height_error_mm"] = e.folds ? number(e.folds->height * 1e3) : Json(nullptr);
  json["fold_slope_error"] = e.folds ? number(e.folds->slope) : Json(nullptr);
  json["sheets"] = e.sheet ? Json(sheet_folder(e)) : Json(nullptr);
  json["missing_frames"] = e.sheet ? Json(e.sheet->missing_frames()) : Json(nullptr);
  return json;
}

Json judgement_json(const Judgement& judgement) {
  Json json{{"fitness", name_of(judgement.fitness)}, {"headline", judgement.headline},
            {"details", judgement.details},          {"undetermined", judgement.undetermined},
            {"experiments", Json::array()},          {"criteria", Json::array()}};
  for (const ExperimentJudgement& e : judgement.experiments) {
    json["experiments"].push_back({{"name", e.experiment},
                                   {"fitness", name_of(e.fitness())},
                                   {"excess", number(e.excess)},
                                   {"span_ratio", number(e.span_ratio)},
                                   {"loop_ratio", number(e.loop_ratio)},
                                   {"explained_variance", number(e.explained)},
                                   {"reasons", e.reasons}});
  }
  for (const CriterionJudgement& c : judgement.criteria) {
    json["criteria"].push_back({{"name", c.key},
                                {"limit", c.limit},
                                {"worst", number(c.worst)},
                                {"experiment", c.worst ? Json(c.experiment) : Json(nullptr)},
                                {"passed", c.passed()},
                                {"text", c.text()}});
  }
  return json;
}

Json covariance_json(const Eigen::MatrixXd& covariance) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < covariance.cols(); ++j) row.push_back(number(covariance(i, j)));
    rows.push_back(row);
  }
  return rows;
}

void add_fit_details(const StudyResult& result, Json& json) {
  json["parameters"] = Json::array();
  for (const auto& p : result.parameters) {
    json["parameters"].push_back(parameter_json(p, "component"));
  }
  json["nuisance"] = Json::array();
  for (const auto& p : result.nuisance) {
    json["nuisance"].push_back(parameter_json(p, "experiment"));
  }
  json["covariance"] = covariance_json(result.covariance);
  json["singular_values"] = Json::array();
  for (const auto& [component, values] : result.singular_values) {
    json["singular_values"].push_back(
        {{"component", component},
         {"values", numbers(std::vector<double>(values.begin(), values.end()))}});
  }
}

/// Null where no sheets were fitted. The seconds add up to those of the fit.
Json work_json(const StudyResult& result) {
  if (!result.work) return nullptr;
  const auto& [counts, seconds] = *result.work;
  return {{"equilibria", counts.equilibria},
          {"newton_iterations", counts.iterations},
          {"factorizations", counts.factors},
          {"differentiated", counts.differentiated},
          {"equilibria_by_differences", counts.equilibria + counts.differences},
          {"seconds",
           {{"equilibria", seconds.search},
            {"derivatives", seconds.derivatives},
            {"rest", std::max(result.seconds - seconds.search - seconds.derivatives, 0.0)}}}};
}

void add_searches(const StudyResult& result, Json& json) {
  json["work"] = work_json(result);
  json["stages"] = Json::array();
  for (const FitStage& s : result.stages) {
    json["stages"].push_back({{"component", s.component},
                              {"name", s.name},
                              {"rms", number(s.rms)},
                              {"unit", s.unit},
                              {"accepted", s.accepted},
                              {"ended", s.ended.empty() ? Json(nullptr) : Json(s.ended)}});
  }
  json["starts"] = Json::array();
  for (const StartRecord& s : result.starts) {
    json["starts"].push_back({{"component", s.component},
                              {"search", s.search},
                              {"tried", s.ends.size()},
                              {"followed", s.followed},
                              {"reached_best", s.reached_best},
                              {"unit", s.unit},
                              {"ends", s.ends}});
  }
  json["models"] = Json::array();
  for (const ModelRank& m : result.models) {
    json["models"].push_back({{"component", m.component},
                              {"name", m.name},
                              {"parameters", m.parameters},
                              {"rms_percent_of_peak", number(m.rms_percent)},
                              {"aic", number(m.aic)},
                              {"bic", number(m.bic)},
                              {"delta_bic", number(m.delta_bic)},
                              {"told_by", m.told_by}});
  }
  json["profiles"] = Json::array();
  for (const Profile& p : result.profiles) {
    json["profiles"].push_back({{"parameter", p.parameter},
                                {"unit", p.unit},
                                {"value", numbers(p.value)},
                                {"delta_chi2", numbers(p.delta_chi2)},
                                {"lower", number(p.lower)},
                                {"upper", number(p.upper)},
                                {"std_error", number(p.std_error)}});
  }
}

std::string parameters_csv(const StudyResult& result) {
  const std::vector<std::string> header{
      "name",  "value",      "std_error", "unit",  "lower",
      "upper", "identified", "at_bound",  "fixed", "between_specimen_sd"};
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  CsvWriter csv(header);
  for (const auto* list : {&result.parameters, &result.nuisance}) {
    for (const ParameterEstimate& p : *list) {
      csv.cell(p.name).cell(p.value).cell(p.std_error.value_or(kNone)).cell(p.unit);
      csv.cell(p.lower.value_or(kNone)).cell(p.upper.value_or(kNone));
      csv.cell(p.identified ? 1 : 0).cell(p.at_bound ? 1 : 0).cell(p.fixed ? 1 : 0);
      csv.cell(p.between_specimen_sd.value_or(kNone));
      csv.end_row();
    }
  }
  return csv.text();
}

std::string curves_csv(const StudyResult& result) {
  const std::vector<std::string> header{"component", "strain", "load",    "unload",
                                        "low",       "high",   "elastic", "friction_max"};
  CsvWriter csv(header);
  for (const ComponentCurve& c : result.curves) {
    for (size_t i = 0; i < c.strain.size(); ++i) {
      csv.cell(c.component).cell(c.strain[i]).cell(c.load[i]).cell(c.unload[i]);
      csv.cell(c.low[i]).cell(c.high[i]).cell(c.elastic[i]).cell(c.max_friction[i]);
      csv.end_row();
    }
  }
  return csv.text();
}

// The experiment's own columns keep their names; ours give way where they would clash.
std::vector<OwnColumn> own_columns(const ExperimentResult& e) {
  std::vector<OwnColumn> columns;
  for (const OwnColumn& column : e.columns) {
    const bool ours = column.header == "specimen" || column.header == "strain" ||
                      column.header == "branch" || column.header == "used";
    if (!ours) columns.push_back(column);
  }
  return columns;
}

const char* branch_name(int direction) { return direction > 0 ? "load" : "unload"; }

std::string prediction_csv(const ExperimentResult& e) {
  const std::vector<OwnColumn> own = own_columns(e);
  std::vector<std::string> header;
  for (const OwnColumn& column : own) header.push_back(column.header);
  for (const char* name : {"specimen", "strain", "branch", "used"}) header.push_back(name);
  header.push_back("measured_" + e.quantity.name);
  header.push_back("predicted_" + e.quantity.name);
  if (e.elastic) header.push_back("elastic_" + e.quantity.name);
  if (e.half_band) {
    for (const char* side : {"low_", "high_"}) header.push_back(side + e.quantity.name);
  }

  CsvWriter csv(header);
  for (Eigen::Index i = 0; i < e.measured.size(); ++i) {
    const auto row = static_cast<size_t>(i);
    for (const OwnColumn& column : own) csv.cell(column.cells[row]);
    csv.cell(e.specimens[static_cast<size_t>(e.specimen_of_row[row])]);
    csv.cell(e.strain[row]).cell(branch_name(e.direction_of_row[row])).cell(e.used[row] ? 1 : 0);
    csv.cell(e.quantity.per_si * e.measured(i)).cell(e.quantity.per_si * e.predicted(i));
    if (e.elastic) csv.cell(e.quantity.per_si * (*e.elastic)(i));
    if (e.half_band) {
      csv.cell(e.quantity.per_si * (e.predicted(i) - (*e.half_band)(i)));
      csv.cell(e.quantity.per_si * (e.predicted(i) + (*e.half_band)(i)));
    }
    csv.end_row();
  }
  return csv.text();
}

void add_session(const Session& session, const std::string& folder,
                 std::vector<std::pair<std::string, std::string>>& files) {
  for (auto& [name, content] : session_files(session)) {
    files.emplace_back(folder + name, std::move(content));
  }
}

void add_tables(const StudyResult& result,
                std::vector<std::pair<std::string, std::string>>& files) {
  files.emplace_back("curves.csv", curves_csv(result));
  if (result.material.kind == MaterialKind::cloth) {
    files.emplace_back("figures.csv", figures_csv(result));
  }
  for (const ExperimentResult& experiment : result.experiments) {
    files.emplace_back(prediction_file(experiment), prediction_csv(experiment));
    if (experiment.shapes) files.emplace_back(shape_file(experiment), shape_table(experiment));
    if (has_measures(experiment)) {
      files.emplace_back(measure_file(experiment), frame_measure_table(*experiment.sheet));
    }
    if (!experiment.sheet) continue;
    const SheetComparison& sheet = *experiment.sheet;
    add_session(with_frames(sheet.measured, sheet.frames), sheet_folder(experiment) + "/measured/",
                files);
    add_session(sheet.predicted, sheet_folder(experiment) + "/predicted/", files);
  }
}

Json skipped_json(const StudyResult& result) {
  Json skipped = Json::array();
  for (const SkippedExperiment& e : result.skipped) {
    skipped.push_back({{"name", e.name}, {"missing", e.missing}});
  }
  return skipped;
}

}  // namespace

std::string summary_text(const StudyResult& result, const RunFacts& facts, bool fitted) {
  Json json{{"pliant", fitted ? "fit/1" : "evaluation/1"},
            {"name", result.name},
            {"density", result.density > 0 ? Json(result.density) : Json(nullptr)},
            {"info", result.info},
            {"conditions", result.conditions},
            {"command", facts.command},
            {"created", facts.created},
            {"version", facts.version},
            {"study", facts.study},
            {"study_sha256", facts.study_sha256}};
  json["data"] = Json::array();
  for (const DataFile& d : result.data) {
    json["data"].push_back({{"experiment", d.experiment}, {"file", d.file}, {"sha256", d.sha256}});
  }
  if (fitted) {
    json["estimator"] = result.estimator == EstimatorKind::path ? "path" : "anchor";
  } else {
    json["material"] = facts.material_file;
  }
  json["converged"] = result.converged;
  json["seconds"] = result.seconds;
  if (fitted) add_fit_details(result, json);
  json["experiments"] = Json::array();
  for (const ExperimentResult& e : result.experiments) {
    json["experiments"].push_back(experiment_json(e));
  }
  if (!fitted) json["whole_sheets"] = whole_sheets_json(result.whole_sheets);
  json["membrane"] = name_of(result.material.membrane);
  json["figures"] = Json::array();
  for (const LabFigure& figure : result.figures) json["figures"].push_back(figure_json(figure));
  if (fitted) add_searches(result, json);
  json["judgement"] = judgement_json(result.judgement);
  json["undetermined"] = result.undetermined;
  json["assumptions"] = result.assumptions;
  if (!fitted) json["skipped"] = skipped_json(result);
  json["questions"] = result.questions;
  std::vector<std::string> warnings = result.questions;
  warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
  json["warnings"] = warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::pair<std::string, std::string>> fit_files(const StudyResult& result,
                                                           const RunFacts& facts) {
  Material material = result.material;
  material.provenance = {{"study", facts.study},
                         {"study_sha256", facts.study_sha256},
                         {"command", facts.command},
                         {"pliant_version", facts.version},
                         {"created", facts.created}};
  std::vector<std::pair<std::string, std::string>> files;
  files.emplace_back("material.json", material_text(material));
  files.emplace_back("fit.json", summary_text(result, facts, true));
  files.emplace_back("parameters.csv", parameters_csv(result));
  add_tables(result, files);
  if (result.body) {
    const bool solid = result.material.kind == MaterialKind::solid;
    files.emplace_back(solid ? "body.vtu" : "sheet.vtu", body_map(result));
  }
  return files;
}

std::vector<std::pair<std::string, std::string>> evaluation_files(const StudyResult& result,
                                                                  const RunFacts& facts) {
  std::vector<std::pair<std::string, std::string>> files;
  files.emplace_back("evaluation.json", summary_text(result, facts, false));
  add_tables(result, files);
  add_files(result.whole_sheets, files);
  return files;
}

}  // namespace pliant
