#include "pliant/study/study_fit.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_work.h"
#include "pliant/estimation/estimate.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/experiment/registry.h"
#include "pliant/material/sheet_metric.h"
#include "pliant/study/component_study.h"
#include "pliant/study/conclusion.h"
#include "pliant/study/joint_study.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/solid_study.h"
#include "pliant/study/study_experiments.h"
#include "pliant/study/whole_sheets.h"

namespace pliant {
namespace {

// Types whose experiments tell one component.
std::vector<std::string_view> names_of_table_tests() {
  std::vector<std::string_view> names;
  for (const TestType* type : test_types()) {
    if (type->make) names.push_back(type->name);
  }
  return names;
}

void warn_of_unknown_profiles(const StudyFitOptions& options, StudyResult& result) {
  for (const std::string& pattern : options.profiles) {
    const bool known =
        std::any_of(result.profiles.begin(), result.profiles.end(),
                    [&](const Profile& profile) { return matches(pattern, profile.parameter); });
    if (known) continue;
    result.warnings.push_back("no free parameter of strips is called " + pattern + ": no profile");
  }
}

void warn_of_sheets(const Study& study, StudyResult& result) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_sheet(spec, study.model)) continue;
    result.warnings.push_back(
        spec.name +
        ": left out, as a sheet needs all components of a material and strips tell some; "
        "`pliant evaluate` predicts it with a complete material");
  }
}

/// Sheets are simulated with shear. In one dimension a bias strip has a stiffness of its own.
void tell_of_shear(const std::vector<ComponentWork>& works, StudyResult& result) {
  const auto has = [&](const char* component) {
    return std::ranges::any_of(
        works, [&](const ComponentWork& work) { return work.component == component; });
  };
  if (!has("stretch.bias") || has("shear")) return;
  result.undetermined.emplace_back(
      "shear: bias strips tell it where they are fitted as sheets (model: {strips: sheet})");
}

/// A strip that is strained evenly has one strain, and no limit of energy.
void refuse_models_of_sheets(const Study& study) {
  const auto refuse = [&](const std::string& field, const char* what) {
    throw InputError({study.file, 0, field},
                     fmt::format("{}, which strips in one dimension do not tell", what),
                     "sessions to fit, or `model: {strips: sheet}`");
  };
  for (const auto& [name, component] : study.model.components) {
    if (solid_metric_of(name)) refuse("model.components." + name, "acts on several strains");
  }
  if (!study.model.limits.empty()) refuse("model.limits", "is of sheets");
  if (study.model.samples) refuse("model.samples", "is of whole sheets");
}

/// Each component of strips is fitted for itself, at once.
void refuse_plan(const Study& study) {
  if (study.fit.plan.empty()) return;
  throw InputError(study.fit.plan.front().where,
                   "is a stage of sheets or solids, and strips in one dimension have none",
                   "sessions to fit, `model: {strips: sheet}`, or no plan");
}

StudyResult fit_strips(const Study& study, const StudyFitOptions& options,
                       const RunContext& context) {
  refuse_models_of_sheets(study);
  refuse_plan(study);
  if (study.model.isotropic) {
    throw InputError({study.file, 0, "model.variant"},
                     "components are fitted one by one: weft and warp have nothing to share",
                     "nonlinear-orthotropic or linear-orthotropic, or sessions to fit");
  }
  const Stopwatch watch;
  StudyResult result = describe(study);
  const Experiments experiments = read_experiments(study, result);
  warn_of_sheets(study, result);
  if (std::ranges::none_of(experiments, [](const auto& experiment) {
        return experiment->info().role == ExperimentRole::fit;
      })) {
    throw InputError({study.file, 0, "experiments"}, "no experiment that this version can fit",
                     fmt::format("at least one of {} that is not under `validate`",
                                 fmt::join(names_of_table_tests(), ", ")));
  }
  result.assumptions = assumptions_of(study, experiments);
  const std::vector<std::string> stated = stated_options(study.fit);
  result.assumptions.insert(result.assumptions.end(), stated.begin(), stated.end());
  const std::vector<ComponentWork> works =
      fit_components(settings_of(study), experiments, options, context, result);
  for (const ComponentWork& work : works) {
    if (work.problem) add_component(work, result);
  }
  tell_of_shear(works, result);
  warn_of_unmatched_options(study.fit, result);
  result.covariance = joint_covariance(works);
  result.material = material_of(study, works);
  for (const ComponentWork& work : works) {
    if (work.problem) add_figures(work, result.material, result);
  }
  result.seconds = watch.seconds();
  return result;
}

}  // namespace

StudyResult fit_study(const Study& study, const StudyFitOptions& options,
                      const RunContext& context) {
  if (measures_solids(study)) return fit_solid_study(study, context);
  const auto fit = [&] {
    if (!fits_sheets(study)) return fit_strips(study, options, context);
    // The stages of sheets know squares alone; the fit of everything together knows losses.
    const bool together = fits_strips(study) || study.fit.loss != RobustLoss::none;
    return together ? fit_joint_study(study, options, context) : fit_sheet_study(study, context);
  };
  StudyResult result = fit();
  warn_of_bounds(result);
  warn_of_unknown_profiles(options, result);
  warn_of_whole_sheets(study, result);
  conclude_fit(study, result);
  return result;
}

}  // namespace pliant
