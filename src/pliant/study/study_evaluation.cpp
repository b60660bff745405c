#include "pliant/study/study_evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/experiment_result.h"
#include "pliant/material/fill.h"
#include "pliant/material/use_warnings.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

/// Of the components that experiments in one dimension and sheets were predicted with.
void warn_of_guesses(const Material& material, StudyResult& result) {
  std::vector<std::string> used;
  for (const ExperimentResult& row : result.experiments) {
    if (row.sheet) used = sheet_component_names();
  }
  for (const ExperimentResult& row : result.experiments) used.push_back(row.component);
  std::ranges::move(undetermined_warnings(material, used), std::back_inserter(result.warnings));
}

}  // namespace

StudyResult evaluate_study(const Study& study, const Material& material,
                           const RunContext& context) {
  const Stopwatch watch;
  StudyResult result = describe(study);
  result.material = material;
  if (result.density == 0) result.density = material.density;
  Study with_measure = study;
  with_measure.model.membrane = material.membrane;
  with_measure.model.bending = material.bending;
  with_measure.density = result.density;
  const Experiments experiments = read_experiments(with_measure, result);
  for (const auto& experiment : experiments) {
    context.stop.throw_if_requested();
    const ExperimentInfo& info = experiment->info();
    const std::optional<ComponentLaw> law = law_of(material, info.component);
    if (!law) {
      throw InputError({study.file, 0, info.name},
                       fmt::format("the material {} has no {}: unmeasured",
                                   quoted_value(material.name), info.component),
                       "a material in which that component was measured or assumed");
    }
    ExperimentResult row = compare(*experiment, *law, experiment->unfitted_nuisance(*law));
    row.role = ExperimentRole::validate;
    result.experiments.push_back(std::move(row));
    const bool drawn =
        std::any_of(result.curves.begin(), result.curves.end(),
                    [&](const ComponentCurve& c) { return c.component == info.component; });
    if (!drawn) {
      const auto [low, high] = result.experiments.back().strain_range;
      result.curves.push_back(
          component_curve(info.component, *law, std::max(std::abs(low), std::abs(high)), {}));
    }
  }
  evaluate_sheets(with_measure, material, context, result);
  warn_of_guesses(material, result);
  result.assumptions = assumptions_of(study, experiments);
  result.seconds = watch.seconds();
  result.judgement = judge(result, study.accept, /*evaluation=*/true);
  return result;
}

}  // namespace pliant
