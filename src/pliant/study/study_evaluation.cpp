#include "pliant/study/study_evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/experiment_result.h"
#include "pliant/experiment/row_times.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/use_warnings.h"
#include "pliant/study/conclusion.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/solid_study.h"
#include "pliant/study/study_experiments.h"
#include "pliant/study/whole_sheets.h"

namespace pliant {
namespace {

void refuse_solid(const Study& study, const Material& material) {
  if (material.kind == MaterialKind::cloth) return;
  throw InputError({study.file, 0, "experiments"},
                   "are of cloth, and the material " + quoted_value(material.name) + " is a solid",
                   "a material of kind `cloth`");
}

/// Of the components that experiments in one dimension and sheets were predicted with.
void warn_of_guesses(const Material& material, StudyResult& result) {
  std::vector<std::string> used;
  for (const ExperimentResult& row : result.experiments) {
    if (row.sheet) used = components_of_sheet(material);
  }
  for (const ExperimentResult& row : result.experiments) used.push_back(row.component);
  std::ranges::move(undetermined_warnings(material, used), std::back_inserter(result.warnings));
}

/// What the study and the material say of the fabric and of the model must agree.
void ask_about_fabric(const Study& study, const Material& material, StudyResult& result) {
  constexpr double kAgreement = 0.1;  // lots of one fabric differ by less
  const std::string name = quoted_value(material.name);
  if (study.density > 0 && material.density > 0 &&
      std::abs(material.density - study.density) > kAgreement * study.density) {
    result.questions.push_back(
        fmt::format("the material {} weighs {}, the study's fabric {}: is it the same fabric?",
                    name, format_quantity(material.density, Dimension::area_density),
                    format_quantity(study.density, Dimension::area_density)));
  }
  const ModelOptions usual;
  const bool states_membrane = study.model.membrane != usual.membrane;
  if (states_membrane && study.model.membrane != material.membrane) {
    result.questions.push_back(fmt::format(
        "the study's model measures strain by {}, the material {} by {}, which is used: was it "
        "fitted to this study?",
        name_of(study.model.membrane), name, name_of(material.membrane)));
  }
  const bool states_bending = study.model.bending != usual.bending;
  if (states_bending && study.model.bending != material.bending) {
    result.questions.push_back(
        fmt::format("the study's model bends by {}, the material {} by {}, which is used: was it "
                    "fitted to this study?",
                    study.model.bending, name, material.bending));
  }
}

/// Bending of hinges is that of one mesh; strips show that of the sheet.
void ask_about_hinges(const Material& material, const Experiments& experiments,
                      StudyResult& result) {
  if (material.bending_of == "sheet") return;
  for (const auto& experiment : experiments) {
    if (!is_bending(experiment->info().component)) continue;
    result.questions.push_back(fmt::format(
        "the bending of the material {} is that of {}, and strips show that of the sheet: {} and "
        "what else bends strips is predicted as if both were the same (expected: `bending_of` "
        "sheet)",
        quoted_value(material.name), material.bending_of, experiment->info().name));
    return;
  }
}

/// The nuisance parameters of an experiment as a fit found them; nothing where it has none, or one
/// is not known.
std::optional<Eigen::VectorXd> fitted_nuisance(const Experiment& experiment,
                                               const FoundNuisance& found) {
  const std::vector<NuisanceParameter> own = experiment.nuisance();
  if (own.empty()) return std::nullopt;
  Eigen::VectorXd values(std::ssize(own));
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto known = found.others.find(own[i].name);
    if (known == found.others.end()) return std::nullopt;
    values(static_cast<Eigen::Index>(i)) = known->second;
  }
  return values;
}

/// What a prediction with a law leaves out of an experiment where no fit tells its numbers.
LeftOut left_out_of(const Experiment& experiment, const ComponentLaw& law,
                    const Eigen::VectorXd& unfitted) {
  LeftOut left_out{experiment.info().name, {}};
  const std::vector<NuisanceParameter>& own = experiment.nuisance();
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool read_off = unfitted(static_cast<Eigen::Index>(i)) != 0;
    const bool means_nothing = own[i].of_friction && law.friction_law == FrictionLaw::none;
    if (read_off || means_nothing) continue;
    std::string words = own[i].name.substr(own[i].name.rfind('.') + 1);
    std::ranges::replace(words, '_', ' ');
    if (std::ranges::find(left_out.numbers, words) == left_out.numbers.end()) {
      left_out.numbers.push_back(std::move(words));
    }
  }
  return left_out;
}

/// An experiment with the numbers of the fit of the material, or as on an ideal apparatus.
/// @param was_fitted  by the study, where it is not only predicted in its fit too
ExperimentResult evaluated(const ComponentExperiment& experiment, const ComponentLaw& law,
                           const FoundNuisance& found, bool was_fitted, StudyResult& result) {
  if (const auto fitted = fitted_nuisance(experiment, found)) {
    ExperimentResult row = compare(experiment, law, *fitted);
    row.handled.emplace_back("its own numbers are those of the fit of the material");
    return row;
  }
  const Eigen::VectorXd unfitted = experiment.unfitted_nuisance(law);
  ExperimentResult row = compare(experiment, law, unfitted);
  row.handled.push_back(unfitted_note(experiment.info(), "the material as it is given"));
  LeftOut left_out = left_out_of(experiment, law, unfitted);
  if (was_fitted && !left_out.numbers.empty()) result.left_out.push_back(std::move(left_out));
  return row;
}

void warn_of_left_out(StudyResult& result) {
  std::map<std::vector<std::string>, std::vector<std::string>> alike;
  for (const LeftOut& e : result.left_out) alike[e.numbers].push_back(e.experiment);
  for (const auto& [numbers, experiments] : alike) {
    result.warnings.push_back(fmt::format(
        "left out of {}, so that it counts as error of the material: {} (a fit of this study finds "
        "it; evaluate takes it from the fit.json beside the material)",
        fmt::join(experiments, ", "), fmt::join(numbers, ", ")));
  }
}

void skip_unknown(const Material& material, Experiments& experiments, StudyResult& result) {
  std::erase_if(experiments, [&](const auto& experiment) {
    const ExperimentInfo& info = experiment->info();
    if (law_of(material, info.component)) return false;
    result.skipped.push_back({info.name, {info.component}});
    return true;
  });
}

/// In one dimension limits of energy are not known, nor what one strain does to another, nor where
/// a strip was cut.
void warn_of_one_dimension(const Material& material, const Experiments& experiments,
                           StudyResult& result) {
  const auto leave_out = [&](const std::string& name) {
    result.warnings.push_back(
        fmt::format("{} is left out of strips, which are predicted in one dimension", name));
  };
  const bool pulled = std::ranges::any_of(experiments, [](const auto& experiment) {
    return !is_bending(experiment->info().component);
  });
  for (const std::string& component : components_of_sheet(material)) {
    if (pulled && solid_metric_of(component)) leave_out(component);
  }
  for (const EnergyLimit& limit : material.limits) {
    const bool concerned = std::ranges::any_of(experiments, [&](const auto& experiment) {
      return std::ranges::find(limit.of, experiment->info().component) != limit.of.end();
    });
    if (concerned) leave_out(limit_name(limit.of));
  }
  for (const auto& experiment : experiments) {
    const ExperimentInfo& info = experiment->info();
    if (!differs_in(material, info.component)) continue;
    result.warnings.push_back(
        fmt::format("{}: {} differs from place to place; the mean of its samples predicts strips",
                    info.name, info.component));
  }
}

/// @throws InputError where every experiment was skipped
void refuse_if_nothing_is_left(const Study& study, const Material& material,
                               const StudyResult& result) {
  if (!result.experiments.empty() || !result.whole_sheets.empty()) return;
  std::set<std::string> missing;
  for (const SkippedExperiment& e : result.skipped) {
    missing.insert(e.missing.begin(), e.missing.end());
  }
  throw InputError(
      {study.file, 0, "experiments"},
      fmt::format("the material {} predicts none of them: it has no {} (unmeasured)",
                  quoted_value(material.name), fmt::join(missing, ", ")),
      "a material in which a component that an experiment needs was measured or assumed");
}

}  // namespace

StudyResult evaluate_study(const Study& study, const Material& material, const RunContext& context,
                           const FoundNuisance& found) {
  if (measures_solids(study)) return evaluate_solid_study(study, material, context);
  refuse_solid(study, material);
  const Stopwatch watch;
  StudyResult result = describe(study);
  result.material = material;
  if (result.density == 0) result.density = material.density;
  Study with_measure = study;
  with_measure.model.membrane = material.membrane;
  with_measure.model.bending = material.bending;
  with_measure.density = result.density;
  for (ExperimentSpec& spec : with_measure.experiments) spec.role = ExperimentRole::validate;
  ask_about_fabric(study, material, result);
  Experiments experiments = read_experiments(with_measure, result);
  skip_unknown(material, experiments, result);
  warn_of_one_dimension(material, experiments, result);
  ask_about_hinges(material, experiments, result);
  for (const auto& experiment : experiments) {
    context.stop.throw_if_requested();
    const ExperimentInfo& info = experiment->info();
    const std::optional<ComponentLaw> law = law_of(material, info.component);
    PLIANT_ASSERT(law.has_value(), "experiments without their component are skipped");
    if (law->flows() && info.test.follows_time) {
      require_times(*experiment, {study.file, 0, "experiments"});
    }
    const auto spec = std::ranges::find(study.experiments, info.name, &ExperimentSpec::name);
    result.experiments.push_back(
        evaluated(*experiment, *law, found, spec->role == ExperimentRole::fit, result));
    const bool drawn =
        std::any_of(result.curves.begin(), result.curves.end(),
                    [&](const ComponentCurve& c) { return c.component == info.component; });
    if (!drawn) {
      const auto [low, high] = result.experiments.back().strain_range;
      result.curves.push_back(
          component_curve(info.component, *law, std::max(std::abs(low), std::abs(high)), {}));
    }
  }
  evaluate_sheets(with_measure, material, found.cords, context, result);
  evaluate_whole_sheets(with_measure, material, context, result);
  warn_of_left_out(result);
  warn_of_guesses(material, result);
  refuse_if_nothing_is_left(study, material, result);
  result.assumptions = assumptions_of(study, experiments);
  result.seconds = watch.seconds();
  conclude_evaluation(study, result);
  return result;
}

}  // namespace pliant
