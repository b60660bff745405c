#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/estimation/component_fit.h"
#include "pliant/experiment/loop_figures.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/experiment/session/sheet_test.h"
#include "pliant/experiment/standard_figures.h"
#include "pliant/experiment/textile_figure.h"
#include "pliant/measurement/data_source.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/study.h"
#include "pliant/study/study_experiments.h"
#include "pliant/study/whole_sheets.h"

#include "apps/pliant/file_info.h"
#include "apps/pliant/solid_info.h"

namespace pliant {
namespace {

/// A file that is missing is an error of the study that names it, at its line; all of them are
/// named at once.
void refuse_missing_data(const Study& study) {
  std::vector<std::string> missing;
  std::optional<Location> first;
  for (const ExperimentSpec& spec : study.experiments) {
    for (const std::filesystem::path& file : spec.data.files) {
      if (std::filesystem::exists(file)) continue;
      if (!first) first = spec.data.where;
      missing.push_back(quoted_value(file.string()));
    }
  }
  if (missing.empty()) return;
  throw InputError(
      *first,
      fmt::format("{} {} not exist", fmt::join(missing, ", "), missing.size() == 1 ? "does" : "do"),
      "existing files, named relative to the study");
}

int count_reversals(const MeasuredPath& path) {
  int reversals = 0;
  for (std::size_t i = 1; i < path.direction.size(); ++i) {
    const bool same_specimen = path.specimen[i] == path.specimen[i - 1];
    if (same_specimen && path.direction[i] != path.direction[i - 1]) ++reversals;
  }
  return reversals;
}

template <class Data>
void add_remarks(const std::string& experiment, const Data& data, FileInfo& info) {
  for (const auto* sentences : {&data.questions, &data.warnings}) {
    for (const std::string& text : *sentences) info.warnings.push_back(experiment + ": " + text);
  }
}

Json file_names(const DataSource& data) {
  Json names = Json::array();
  for (const auto& file : data.files) names.push_back(file.string());
  return names;
}

Json spec_json(const ExperimentSpec& spec) {
  const auto or_null = [](double value) { return value > 0 ? Json(value) : Json(nullptr); };
  return {{"name", spec.name},
          {"type", spec.type},
          {"direction", spec.direction},
          {"role", spec.role == ExperimentRole::fit ? "fit" : "validate"},
          {"data", file_names(spec.data)},
          {"length", or_null(spec.test->length)},
          {"width", or_null(spec.test->width)}};
}

std::string heading(const ExperimentSpec& spec) {
  return spec.direction.empty() ? spec.type : spec.type + ", " + spec.direction;
}

std::string specimens_text(const std::vector<std::string>& names) {
  return names.size() == 1 ? "1 specimen"
                           : fmt::format("{} specimens ({})", names.size(), fmt::join(names, ", "));
}

void add_strip(const TestSpec& spec, std::vector<std::string>& lines) {
  if (spec.width == 0) return;
  if (spec.length == 0) {
    lines.push_back(labelled(
        "strip", format_quantity(spec.width, Dimension::length, kInfoDigits) + " wide", 1));
    return;
  }
  lines.push_back(labelled(
      "strip",
      fmt::format("{} long, {} wide", format_quantity(spec.length, Dimension::length, kInfoDigits),
                  format_quantity(spec.width, Dimension::length, kInfoDigits)),
      1));
}

/// What of a session is compared, in words.
std::string compared_text(const SheetTest& test) {
  int compared = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) compared += test.compared(frame);
  const bool positions = test.objective() == SheetObjective::positions;
  std::vector<std::string> clips;
  for (const SessionClip& clip : test.session().clips) clips.push_back(clip.name);
  return fmt::format("{}, {} {} in {} frames{}", name_of(test.objective()), compared,
                     positions ? "free vertices" : "forces", test.frame_count(),
                     clips.empty()
                         ? std::string()
                         : fmt::format(", {} {}", positions ? "between the clips" : "clips",
                                       fmt::join(clips, ", ")));
}

std::string cords_text(const SheetTest& test) {
  const CordFriction& friction = test.cord_friction();
  if (friction.unknown) return "friction unknown: estimated along for each cord";
  if (friction.width == 0) return "friction taken to be none";
  return fmt::format("friction known, a loop of {} for each cord",
                     format_quantity(friction.width, Dimension::force));
}

/// A session: `info` of its directory tells the rest.
void add_session(const ExperimentSpec& spec, FileInfo& info, Json& json) {
  const SheetTest sheet = sheet_test_of(spec, read_session(spec.data.files.front()));
  const Session& session = sheet.session();
  const std::vector<std::string> components = usual_components(session.test);
  std::string tells = spec.role == ExperimentRole::fit ? "fitted" : "predicted, not fitted";
  if (spec.role == ExperimentRole::fit && !components.empty()) {
    tells += ": determines " + components.front();
  }
  info.lines.push_back(labelled(spec.name, fmt::format("session, {}, {}", session.test, tells)));
  info.lines.push_back(labelled("frames",
                                fmt::format("{}, {} vertices, {} clips", session.frame_count(),
                                            session.rest.vertex_count(), session.clips.size()),
                                1));
  info.lines.push_back(labelled("compared", compared_text(sheet), 1));
  const bool forces = sheet.objective() != SheetObjective::positions;
  if (forces) info.lines.push_back(labelled("cords", cords_text(sheet), 1));
  json["test"] = session.test;
  json["frames"] = session.frame_count();
  json["vertices"] = session.rest.vertex_count();
  json["clips"] = session.clips.size();
  json["objective"] = name_of(sheet.objective());
  json["cord_friction"] = nullptr;
  if (forces) {
    const CordFriction& friction = sheet.cord_friction();
    json["cord_friction"] = friction.unknown ? Json("unknown") : Json(friction.width);
  }
  add_remarks(spec.name, session, info);
}

std::string peak_label(const ExperimentInfo& about) {
  if (about.test.has_unknown_zero) return "span of force";
  if (is_contraction(about.component)) return "narrower by";
  return is_bending(about.component) ? "peak moment" : "peak force";
}

/// What the largest of the measured values counts in.
Dimension peak_dimension(const ExperimentInfo& about) {
  if (is_contraction(about.component)) return Dimension::length;
  return about.quantity.kind == "force per width" ? Dimension::force_per_length : Dimension::force;
}

/// What an experiment tells: of a sheet a strip that is cut on the bias tells shear.
std::string component_of(const ExperimentSpec& spec, const ModelOptions& model) {
  const std::string alone = component_of_test(spec.type, spec.direction);
  return is_sheet(spec, model) && alone == "stretch.bias" ? "shear" : alone;
}

/// What standards read off the loop, what the instrument shows of nothing taken off.
void add_loop_figures(const ComponentExperiment& experiment, FileInfo& info, Json& json) {
  if (!experiment.loop(experiment.measured())) return;
  const Eigen::VectorXd zero = experiment.instrument_zero(experiment.unfitted_nuisance({}));
  std::vector<std::string> texts;
  for (const LoopFigure& figure : loop_figures(experiment, experiment.measured() - zero)) {
    const TextileFigure* kind = find_textile_figure(figure.name);
    json["figures"].push_back({{"name", figure.name},
                               {"standard", kind->standard},
                               {"value", kind->per_si * figure.value},
                               {"unit", kind->lab_unit}});
    texts.push_back(fmt::format("{} {}", kind->symbol, in_lab_unit(*kind, figure.value)));
  }
  if (texts.empty()) return;
  info.lines.push_back(
      labelled("figures", fmt::format("{} (KES, FAST, ISO 20932-1)", fmt::join(texts, ", ")), 1));
}

void add_measurements(const ExperimentSpec& spec, const ModelOptions& model,
                      const ComponentExperiment& experiment, FileInfo& info, Json& json) {
  const ExperimentInfo& about = experiment.info();
  const std::string component = component_of(spec, model);
  const MeasuredPath& path = experiment.path();
  const auto used = std::count(about.used.begin(), about.used.end(), 1);
  const auto [low, high] = std::minmax_element(path.strain.begin(), path.strain.end());
  const Dimension peak = peak_dimension(about);
  const bool loop = unloads(path);
  std::vector<std::string> along;
  for (const NuisanceParameter& parameter : experiment.nuisance()) along.push_back(parameter.name);

  json["component"] = component;
  json["rows"] = experiment.rows();
  json["used_rows"] = used;
  json["specimens"] = about.specimens;
  json["peak_force"] = experiment.peak_force();
  json["peak_force_unit"] = si_unit(peak);
  json["strain_range"] = {*low, *high};
  json["unloads"] = loop;
  json["reversals"] = count_reversals(path);
  json["estimated_along"] = along;
  json["handled"] = about.handled;

  auto& lines = info.lines;
  lines.push_back(labelled(
      spec.name, fmt::format("{}, {} {}", heading(spec),
                             spec.role == ExperimentRole::fit ? "fitted: determines"
                                                              : "predicted, not fitted: needs",
                             component)));
  add_strip(*spec.test, lines);
  lines.push_back(labelled("data",
                           fmt::format("{}: {} rows, {} used, {}", spec.data.written,
                                       experiment.rows(), used, specimens_text(about.specimens)),
                           1));
  lines.push_back(
      labelled(peak_label(about), format_quantity(experiment.peak_force(), peak, kInfoDigits), 1));
  lines.push_back(labelled(
      "strain",
      fmt::format("{} to {}", format_number(*low, kInfoDigits), format_number(*high, kInfoDigits)),
      1));
  lines.push_back(labelled(
      "unloads", fmt::format("{}; {} reversals", loop ? "yes" : "no", count_reversals(path)), 1));
  if (!along.empty()) {
    lines.push_back(labelled("estimated along", fmt::format("{}", fmt::join(along, ", ")), 1));
  }
  for (const std::string& text : about.handled) lines.push_back(labelled("handled", text, 1));
  add_remarks(spec.name, about, info);
}

/// A test that is only predicted.
void add_whole_sheet(const ExperimentSpec& spec, FileInfo& info, Json& json) {
  const std::unique_ptr<WholeSheetTest> test = read_whole_sheet_test(spec);
  const ExperimentInfo& about = test->info();
  const double mean = about.quantity.per_si * test->measured().mean();
  info.lines.push_back(labelled(
      spec.name, fmt::format("{}, predicted with a whole material, not fitted", spec.type)));
  info.lines.push_back(
      labelled("data",
               fmt::format("{}: {} rows, mean {} {:.4g} {}", spec.data.written,
                           test->measured().size(), about.quantity.kind, mean, about.quantity.unit),
               1));
  for (const auto& [key, value] : spec.test->fields()) {
    info.lines.push_back(labelled(key, value, 1));
  }
  for (const std::string& text : about.handled) info.lines.push_back(labelled("handled", text, 1));
  json["rows"] = test->measured().size();
  json["mean"] = mean;
  json["unit"] = about.quantity.unit;
  add_remarks(spec.name, about, info);
}

/// @return those that are fitted in one dimension
Experiments add_experiments(const Study& study, FileInfo& info) {
  Experiments experiments;
  info.json["experiments"] = Json::array();
  for (const ExperimentSpec& spec : study.experiments) {
    Json json = spec_json(spec);
    const TestType& type = spec.test->type();
    if (type.facts.measures_sheets) {
      add_session(spec, info, json);
    } else if (is_only_predicted(spec)) {
      add_whole_sheet(spec, info, json);
    } else {
      auto experiment = read_experiment(spec, study);
      add_measurements(spec, study.model, *experiment, info, json);
      add_loop_figures(*experiment, info, json);
      if (!is_sheet(spec, study.model)) experiments.push_back(std::move(experiment));
      if (type.standard_figures) {
        const StandardFigures figures = type.standard_figures(DataRows(spec.data), spec.test.get(),
                                                              study.density * kStandardGravity);
        json[figures.key] = figures.json;
      }
    }
    info.json["experiments"].push_back(std::move(json));
  }
  return experiments;
}

std::string friction_reason(FrictionChoice choice, bool data_unloads) {
  if (choice == FrictionChoice::none) return "as the study says";
  if (choice == FrictionChoice::automatic) {
    return data_unloads ? "the data unloads"
                        : "the data only loads, and friction shows when it unloads";
  }
  return data_unloads ? "as the study says"
                      : "as the study says, but the data only loads and does not determine it";
}

/// What `fit` does with the experiments of one component.
void add_plan(const Study& study, const std::string& component,
              const std::vector<const ComponentExperiment*>& fitted, FileInfo& info) {
  std::vector<std::string> notes;
  const ComponentPlan plan = plan_component(study, fitted, notes);
  const bool data_unloads = any_unloads(fitted);
  const std::string reason =
      friction_reason(friction_of(study.model, component).choice, data_unloads);
  std::string friction = plan.friction == FrictionLaw::none ? "none" : "dahl";
  if (plan.branches > 1) friction += fmt::format(" of up to {} branches", plan.branches);
  std::vector<std::string> names;
  for (const ComponentExperiment* experiment : fitted) names.push_back(experiment->info().name);

  Json json{{"component", component},
            {"experiments", names},
            {"stiffness", name_of(plan.stiffness)},
            {"friction", friction},
            {"friction_because", reason}};
  std::string stiffness = fmt::format("{} stiffness", name_of(plan.stiffness));
  if (plan.stiffness == CurveKind::hermite) {
    json["control_points"] = plan.fit.control_points;
    const bool grows = plan.fit.estimator == EstimatorKind::path;
    stiffness +=
        fmt::format(" of {}{} control points", grows ? "up to " : "", plan.fit.control_points);
  }
  for (const AddendKind* kind : plan.addends) {
    json["addends"].push_back(kind->name);
    stiffness += fmt::format(", {}", kind->description);
  }
  info.json["fit"]["components"].push_back(std::move(json));
  info.lines.push_back(labelled(component,
                                fmt::format("{}, friction {} ({}), from {}", stiffness, friction,
                                            reason, fmt::join(names, ", ")),
                                1));
}

void add_plans(const Study& study, const Experiments& experiments, FileInfo& info) {
  const std::string estimator = study.fit.estimator == EstimatorKind::path ? "path" : "anchor";
  info.json["fit"] = {{"estimator", estimator}, {"components", Json::array()}};
  if (fits_sheets(study)) {
    info.lines.push_back(labelled("fit", "sessions and strips as one sheet, stage by stage"));
    return;
  }
  info.lines.push_back(labelled("fit", "estimator " + estimator));
  for (const std::string& component : cloth_component_names()) {
    std::vector<const ComponentExperiment*> fitted;
    bool validated = false;
    for (const auto& experiment : experiments) {
      if (experiment->info().component != component) continue;
      validated = validated || experiment->info().role == ExperimentRole::validate;
      if (experiment->info().role == ExperimentRole::fit) fitted.push_back(experiment.get());
    }
    if (!fitted.empty()) {
      add_plan(study, component, fitted, info);
    } else if (validated) {
      info.warnings.push_back(component + " has validation experiments alone: not fitted");
    }
  }
  if (!info.json["fit"]["components"].empty()) return;
  info.warnings.push_back("no experiment that this version can fit");
  info.lines.push_back(labelled("", "nothing: no experiment that this version can fit", 1));
}

void add_head(const Study& study, FileInfo& info) {
  info.warnings = describe(study).questions;
  info.json["name"] = study.name;
  info.json["density"] = study.density > 0 ? Json(study.density) : Json(nullptr);
  info.json["info"] = study.info;
  info.json["conditions"] = study.conditions;
  info.lines.push_back(labelled("name", study.name));
  info.lines.push_back(labelled(
      "density", study.density > 0 ? format_quantity(study.density,
                                                     study.model.kind == MaterialKind::solid
                                                         ? Dimension::volume_density
                                                         : Dimension::area_density,
                                                     kInfoDigits)
                                   : "not stated"));
  for (const auto* texts : {&study.info, &study.conditions}) {
    for (const auto& [key, text] : *texts) info.lines.push_back(labelled(key, text));
  }
}

}  // namespace

FileInfo study_info(const std::filesystem::path& path) {
  const Study study = read_study(path);
  refuse_missing_data(study);
  FileInfo info = begin_info(path, "study/1");
  add_head(study, info);
  if (study.model.kind == MaterialKind::solid) {
    add_solid_experiments(study, info);
    info.json["warnings"] = info.warnings;
    return info;
  }
  const Experiments experiments = add_experiments(study, info);
  add_plans(study, experiments, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
