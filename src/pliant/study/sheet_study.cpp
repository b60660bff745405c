#include "pliant/study/sheet_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/estimate.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_plan.h"
#include "pliant/estimation/sheet/sheet_uncertainty.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/experiment/strain_words.h"
#include "pliant/geometry/hinges.h"
#include "pliant/io/digest.h"
#include "pliant/material/bending_conversion.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/math/quantiles.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/study/body_map.h"
#include "pliant/study/sheet_experiment.h"
#include "pliant/study/sheet_predictions.h"
#include "pliant/study/sheet_samples.h"
#include "pliant/study/stated_branches.h"
#include "pliant/study/study_experiments.h"
#include "pliant/study/whole_sheets.h"

namespace pliant {
namespace {

/// What is known of the cords of a clip together, which move alike or nearly so.
std::string loops_together(const SheetUncertainty& fit, std::size_t cord) {
  std::vector<Eigen::Index> all;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown &one = fit.unknowns[cord], &other = fit.unknowns[i];
    if (one.together == other.together) {
      all.push_back(static_cast<Eigen::Index>(i));
    }
  }
  if (all.size() < 2) return {};
  return fmt::format("all {} cords of the clip: {:.3g} +- {:.2g} N", all.size(),
                     fit.values(all).sum(), std::sqrt(fit.uncertainty.covariance(all, all).sum()));
}

ParameterEstimate estimate_of(const SheetUncertainty& fit, MembraneMeasure measure,
                              Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  const Unknown& unknown = fit.unknowns[index];
  ParameterEstimate estimate = estimate_of(fit.unknowns, fit.values, fit.uncertainty, i);
  if (unknown.strain) {
    estimate.note =
        fmt::format("at {}; ", strain_in_words(estimate.owner, *unknown.strain, measure));
  }
  if (fit.mesh_error.size() > 0 && !unknown.fixed) {
    estimate.note += fmt::format("{:.2g} of the error by the mesh; ", std::abs(fit.mesh_error(i)));
  }
  estimate.note +=
      unknown.of_material ? fit.uncertainty.told_by[index] : loops_together(fit, index);
  return estimate;
}

void add_curves_and_figures(const SheetFit& fit, const SheetUncertainty& uncertainty,
                            StudyResult& result) {
  Eigen::Index first = 0;
  for (const ComponentGroup& group : fit.groups) {
    const ComponentLaw law = law_of(fit.material, group);  // of samples the mean, without an error
    const int copies = copies_of(fit.material, group.front());
    const double largest = largest_strain(fit, group);
    for (const std::string& component : group) {
      const ErrorOfLaw error_of =
          copies > 1 ? ErrorOfLaw() : errors_of_law(uncertainty.uncertainty, first);
      result.curves.push_back(component_curve(component, law, largest, error_of));
      std::ranges::move(lab_figures(fit.material, component, error_of),
                        std::back_inserter(result.figures));
    }
    first += copies * law.parameter_count();
  }
}

/// The mesh of the first sheet on a table: those between clips have cells of several sizes.
const TriangleMesh& bent_mesh(const std::vector<SheetExperiment>& experiments) {
  const auto bent = std::ranges::find_if(experiments, [](const SheetExperiment& experiment) {
    return experiment.test.session().table.has_value();
  });
  return (bent == experiments.end() ? experiments.front() : *bent).test.session().rest;
}

/// What hinges make of a sheet: its bending stiffness, which other meshes and strips can be
/// compared with. Of curves the stiffness at half of the largest strain counts.
std::string sheet_bending(const SheetFit& fit, const TriangleMesh& mesh) {
  BendingVector hinges;
  const std::array<const char*, 3> names{"bend.weft", "bend.warp", "bend.diagonal"};
  for (int i = 0; i < 3; ++i) {
    const char* name = names[static_cast<std::size_t>(i)];
    const auto strain = fit.strains.find(name);
    const double half = strain == fit.strains.end() ? 0 : strain->second / 2;
    hinges(i) = std::max(law_of(fit.material.components.at(name)).elastic_secant(half), 1e-12);
  }
  const Eigen::Vector4d sheet = sheet_stiffness(mesh, find_hinges(mesh), hinges);
  return fmt::format(
      "bending is that of the hinges of the simulated mesh; as a sheet it has {:.3g} N m along "
      "weft, "
      "{:.3g} N m along warp, {:.3g} and {:.3g} N m at 45 degrees (M/width = 3 k curvature)",
      sheet(kAlongWeft), sheet(kAlongWarp), sheet(kAlongRising), sheet(kAlongFalling));
}

/// The noise of fitted sheets, which weighs them in standard errors.
void take_sheet_noise(const SheetFit& fit, const SheetUncertainty& uncertainty,
                      std::vector<ExperimentResult>& predictions, StudyResult& result) {
  const std::vector<const SheetTest*> tests = tests_of(fit.plan);
  for (std::size_t part = 0; part < tests.size(); ++part) {
    const auto row = std::ranges::find(predictions, tests[part]->name(), &ExperimentResult::name);
    if (row != predictions.end()) take_noise(uncertainty.uncertainty, part, *row, result);
  }
}

void warn_of_left_out(const Study& study, StudyResult& result) {
  std::vector<std::string> names;
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_sheet(spec, study.model) && !is_only_predicted(spec)) names.push_back(spec.name);
  }
  if (names.empty()) return;
  result.warnings.push_back(fmt::format(
      "experiments in one dimension are left out of a fit of sheets: {}", fmt::join(names, ", ")));
}

/// The experiments once more on grids of twice the edge; none where sheets are simulated on meshes
/// of their own.
std::vector<SheetExperiment> on_coarser_meshes(const Study& study) {
  if (study.model.measured_mesh) return {};
  Study coarse = study;
  coarse.model.mesh_factor = 2;
  StudyResult told_already;
  return read_sheet_experiments(coarse, told_already);
}

std::string about_mesh_error(const SheetUncertainty& uncertainty) {
  return uncertainty.mesh_error.size() > 0
             ? "standard errors contain that of the mesh: by how much the numbers would move on "
               "one "
               "of twice the edge"
             : "standard errors do not contain that of the mesh: there is no second one to compare "
               "with";
}

void ask_about_cords(const std::vector<SheetExperiment>& experiments, StudyResult& result) {
  std::vector<std::string> names;
  for (const SheetExperiment& experiment : experiments) {
    const SheetTest& test = experiment.test;
    if (test.cord_friction().unknown && !test.cords().empty()) names.push_back(test.name());
  }
  if (names.empty()) return;
  result.questions.push_back(fmt::format(
      "the friction of the cords of {} is not known and left out, so their loops are predicted too "
      "narrow: it stands in fit.json beside the material that a fit wrote, or is stated as "
      "`cord_friction`",
      fmt::join(names, ", ")));
}

/// A fit with what it predicts.
struct Candidate {
  SheetFit fit;
  std::vector<ExperimentResult> experiments;
  std::string note;

  Candidate(const FitSettings& settings, SheetFit fitted, const std::vector<SheetExperiment>& data,
            const RunContext& context, std::string how)
      : fit(std::move(fitted)), note(std::move(how)) {
    set_status(settings, fit);
    experiments = sheet_predictions(data, fit.material, fit.cords, context, fit.work);
  }

  /// Frames without equilibrium, whose error nobody knows.
  std::size_t missing_frames() const {
    std::size_t missing = 0;
    for (const ExperimentResult& experiment : experiments) {
      if (experiment.sheet) missing += experiment.sheet->missing_frames().size();
    }
    return missing;
  }
};

/// The best of the fits that begin with nothing and at each start, and of the starts themselves;
/// its work is that of all. One that finds no equilibria leaves it to the others.
/// @throws SolverError where all of them find none
Candidate best_fit(const FitSettings& settings, const std::vector<SheetStage>& plan,
                   const std::vector<SheetExperiment>& experiments, const RunContext& context,
                   const std::vector<SheetStart>& starts) {
  std::optional<Candidate> best;
  EquilibriumWork work;
  std::exception_ptr failure;
  const auto rank = [](const Candidate& fit) {
    return std::pair(fit.missing_frames(), misfit_percent(fit.experiments));
  };
  const auto consider = [&](SheetFit fit, std::string how) {
    Candidate other(settings, std::move(fit), experiments, context, std::move(how));
    work += other.fit.work;
    if (!best || rank(other) < rank(*best)) best = std::move(other);
  };
  const auto try_to = [&](const auto& search) {
    try {
      search();
    } catch (const SolverError&) {
      if (!failure) failure = std::current_exception();
    }
  };
  try_to([&] { consider(fit_sheets(settings, plan, context), ""); });
  for (const SheetStart& start : starts) {
    try_to([&] {
      SheetFit fit = fit_sheets(settings, plan, context, &start.material);
      consider(fit, "the search that began at the solution of " + start.variant + " is the best");
      fit.material = start.material;
      fit.cords = start.cords;
      fit.stages.clear();
      fit.starts.clear();
      fit.work = {};
      consider(std::move(fit), "no search found better than the solution of " + start.variant);
    });
  }
  if (!best) std::rethrow_exception(failure);
  best->fit.work = work;
  return std::move(*best);
}

}  // namespace

double stated_density(const std::vector<SheetExperiment>& experiments) {
  for (const SheetExperiment& experiment : experiments) {
    const Session& session = experiment.test.session();
    if (states_density(session)) return area_density(session);
  }
  return 0;
}

void set_status(const FitSettings& settings, SheetFit& fit) {
  for (auto& entry : fit.material.components) {
    const std::string& name = entry.first;
    MaterialComponent& component = entry.second;
    if (fixed_stiffness(settings.fit, {name})) {
      component.status = ComponentStatus::measured;
      continue;
    }
    const bool measured = std::ranges::any_of(fit.groups, [&](const ComponentGroup& group) {
      return std::ranges::find(group, name) != group.end();
    });
    component.status = measured ? ComponentStatus::measured : ComponentStatus::assumed;
    if (!measured) continue;
    const std::vector<double>& knots = component.stiffness->knots();
    component.range = {0.0, knots.size() < 2 ? largest_strain(fit, {name}) : knots.back()};
    for (SampledComponents& sample : fit.material.samples.at) {
      const auto own = sample.components.find(name);
      if (own == sample.components.end()) continue;
      own->second.range = component.range;
      own->second.status = component.status;
    }
  }
}

void refuse_foreign_options(const FitSettings& settings) {
  const auto refuse = [&](const char* field, const std::string& what, const char* expected) {
    throw InputError({settings.file, 0, field}, what, expected);
  };
  if (settings.model.stiffness == CurveKind::affine) {
    refuse("model.stiffness", "sheets are not fitted with affine stiffnesses",
           "constant or hermite");
  }
  for (const auto& [name, component] : settings.model.components) {
    const std::string field = "model.components." + name + ".stiffness";
    if (component.stiffness == CurveKind::affine) {
      refuse(field.c_str(), "sheets are not fitted with affine stiffnesses", "constant or hermite");
    }
    if (std::ranges::any_of(component.addends, &AddendKind::flows)) {
      refuse(("model.components." + name + ".addends").c_str(),
             "asks for what flows with time, and sheets are fitted along equilibria without it",
             "laws without time, or strips in one dimension");
    }
    if (component.stiffness == CurveKind::none &&
        std::ranges::all_of(component.addends,
                            [](const AddendKind* kind) { return remembers(*kind); })) {
      refuse(field.c_str(), "is `none`, and no addend is elastic: a sheet needs stiffness at rest",
             "constant or hermite, or an elastic addend");
    }
  }
  if (settings.fit.estimator == EstimatorKind::anchor) {
    refuse("fit.estimator", "the published estimator of friction knows no sheets", "path");
  }
}

std::vector<const SheetTest*> tests_to_fit(const std::vector<SheetExperiment>& experiments) {
  std::vector<const SheetTest*> tests;
  for (const SheetExperiment& experiment : experiments) {
    if (experiment.role == ExperimentRole::fit) tests.push_back(&experiment.test);
  }
  return tests;
}

FitSettings settings_of(const Study& study) {
  FitSettings settings = study;
  const std::filesystem::path folder = std::filesystem::path(study.file).parent_path();
  settings.digest = sha256_of(resolved_study_text(study, folder));
  return settings;
}

void add_sheets(const SheetFit& fit, const SheetUncertainty& uncertainty,
                const std::vector<SheetExperiment>& experiments,
                std::vector<ExperimentResult> predictions, StudyResult& result) {
  result.converged = result.converged && fit.converged;
  result.stages.insert(result.stages.end(), fit.stages.begin(), fit.stages.end());
  result.warnings.insert(result.warnings.end(), fit.warnings.begin(), fit.warnings.end());
  for (const StartRecord& starts : fit.starts) add_starts(starts, result);
  for (Eigen::Index i = 0; i < uncertainty.values.size(); ++i) {
    ParameterEstimate estimate = estimate_of(uncertainty, fit.material.membrane, i);
    const bool cord = !uncertainty.unknowns[static_cast<std::size_t>(i)].of_material;
    (cord ? result.nuisance : result.parameters).push_back(std::move(estimate));
  }
  result.density = fit.material.density;
  result.material = fit.material;
  warn_of_missing_frames(predictions, result);
  warn_of_misfit(experiments, predictions, result);
  take_sheet_noise(fit, uncertainty, predictions, result);
  std::ranges::move(predictions, std::back_inserter(result.experiments));
  add_curves_and_figures(fit, uncertainty, result);
  for (const auto& [name, component] : fit.material.components) {
    if (component.status == ComponentStatus::assumed) {
      result.undetermined.push_back(name + ": no experiment tells it; a guess stands in its place");
    }
  }
  const bool bends = std::ranges::any_of(
      fit.groups, [](const ComponentGroup& group) { return is_bending(group.front()); });
  if (bends && fit.material.bending == "discrete-shells" && fit.material.bending_of == "hinges") {
    result.assumptions.push_back(sheet_bending(fit, bent_mesh(experiments)));
  }
}

bool fits_sheets(const Study& study) {
  return std::ranges::any_of(study.experiments, [&](const ExperimentSpec& spec) {
    return is_sheet(spec, study.model) && spec.role == ExperimentRole::fit;
  });
}

double misfit_percent(const std::vector<ExperimentResult>& experiments) {
  double squares = 0;
  int fitted = 0;
  for (const ExperimentResult& experiment : experiments) {
    if (experiment.role != ExperimentRole::fit) continue;
    squares += experiment.rms_percent * experiment.rms_percent;
    ++fitted;
  }
  return fitted > 0 ? std::sqrt(squares / fitted) : 0;
}

StudyResult fit_sheet_study(const Study& study, const RunContext& context,
                            const std::vector<SheetStart>& starts) {
  const Stopwatch watch;
  StudyResult result = describe(study);
  result.assumptions = stated_options(study.fit);
  refuse_foreign_options(study);
  require_stated_branches(study);
  const std::vector<SheetExperiment> experiments = read_sheet_experiments(study, result);
  warn_of_left_out(study, result);
  require_known_parameters(study, tests_to_fit(experiments));
  const std::vector<SheetStage> plan = sheet_plan(study, tests_to_fit(experiments));
  require_samples_of_sheet(study, tests_to_fit(experiments), plan);
  Candidate best = best_fit(settings_of(study), plan, experiments, context, starts);
  SheetFit& fit = best.fit;
  if (fit.material.density == 0) fit.material.density = stated_density(experiments);
  const std::vector<SheetExperiment> coarser = on_coarser_meshes(study);
  const SheetUncertainty uncertainty =
      sheet_uncertainty(fit, study.fit, context, tests_to_fit(coarser));
  result.assumptions.push_back(about_mesh_error(uncertainty));
  result.work = fit.work;
  *result.work += uncertainty.work;
  result.covariance = uncertainty.uncertainty.covariance;
  add_sheets(fit, uncertainty, experiments, std::move(best.experiments), result);
  if (is_heterogeneous(fit.material)) {
    result.body = grid_at_rest(tests_to_fit(experiments).front()->session().rest);
  }
  if (!best.note.empty()) result.assumptions.push_back("search: " + best.note);
  result.seconds = watch.seconds();
  return result;
}

void evaluate_sheets(const Study& study, const Material& material, const CordFrictions& cords,
                     const RunContext& context, StudyResult& result) {
  const bool any = std::ranges::any_of(
      study.experiments, [&](const ExperimentSpec& spec) { return is_sheet(spec, study.model); });
  if (!any) return;
  std::vector<std::string> missing = sheet_component_names();
  std::erase_if(missing, [&](const std::string& name) { return is_known(material, name); });
  if (!missing.empty()) {
    for (const ExperimentSpec& spec : study.experiments) {
      if (is_sheet(spec, study.model)) result.skipped.push_back({spec.name, missing});
    }
    return;
  }
  require_positive_stiffness(material, sheet_component_names(), {study.file, 0, "experiments"});
  std::vector<SheetExperiment> experiments = read_sheet_experiments(study, result);
  for (SheetExperiment& experiment : experiments) experiment.role = ExperimentRole::validate;
  EquilibriumWork work;
  std::vector<ExperimentResult> rows =
      sheet_predictions(experiments, material, cords, context, work);
  if (cords.empty()) ask_about_cords(experiments, result);
  warn_of_missing_frames(rows, result);
  std::move(rows.begin(), rows.end(), std::back_inserter(result.experiments));
  for (const ExperimentResult& row : result.experiments) {
    const bool drawn = std::ranges::any_of(result.curves, [&](const ComponentCurve& curve) {
      return curve.component == row.component;
    });
    if (drawn || row.component.empty()) continue;
    // What a session says of its strains is how far its clips have moved.
    const auto& range = material.components.at(row.component).range;
    if (!range) continue;
    const ComponentLaw law = law_of(material, ComponentGroup{row.component});
    result.curves.push_back(component_curve(row.component, law, range->second, {}));
  }
}

}  // namespace pliant
