#include "pliant/study/study_experiments.h"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/base/plausibility.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/study/example_data.h"
#include "pliant/study/study.h"
#include "pliant/study/whole_sheets.h"

namespace pliant {

StudyResult describe(const Study& study) {
  StudyResult result;
  result.name = study.name;
  result.density = study.density;
  result.info = study.info;
  result.conditions = study.conditions;
  result.material.membrane = study.model.membrane;
  result.estimator = study.fit.estimator;
  const bool cloth_study = study.model.kind == MaterialKind::cloth;
  if (cloth_study && study.density > 0) {
    Plausibility cloth;
    cloth.add(figures::kAreaDensity, study.density,
              {{cloth.field("density", Dimension::area_density, study.density)}});
    if (auto question = cloth.question()) result.questions.push_back(std::move(*question));
  }
  for (const ExperimentSpec& spec : study.experiments) {
    for (const std::string& doubt : spec.doubts) {
      result.questions.push_back(spec.name + ": " + doubt);
    }
  }
  return result;
}

Experiments read_experiments(const Study& study, StudyResult& result) {
  Experiments experiments;
  for (const ExperimentSpec& spec : study.experiments) {
    if (is_sheet(spec, study.model) || is_only_predicted(spec)) continue;
    experiments.push_back(read_experiment(spec, study));
    if (!spec.after.empty()) {
      const auto earlier =
          std::ranges::find(experiments, spec.after, [](const auto& e) { return e->info().name; });
      PLIANT_ASSERT(earlier != experiments.end(), "studies list them in the order of time");
      auto& later = dynamic_cast<FollowingExperiment&>(*experiments.back());
      later.follow(**earlier, after_location(spec));
    }
    add_remarks(spec.name, experiments.back()->info(), result);
    if (is_example_data(spec)) {
      result.warnings.push_back(spec.name +
                                ": the data are still those of the example that `pliant init` "
                                "writes: the material is that of no fabric of yours");
    }
  }
  return experiments;
}

namespace {

// [P] 4.3 takes the stiffness from a test of its own.
void add_stiffness_of_rolled_strips(const Experiments& experiments,
                                    std::vector<std::string>& assumptions) {
  const auto measures = [&](const std::string& component, bool rolled) {
    return std::any_of(experiments.begin(), experiments.end(), [&](const auto& e) {
      const ExperimentInfo& info = e->info();
      return info.role == ExperimentRole::fit && info.component == component &&
             info.test.bends_by_weight && info.test.is_released == rolled;
    });
  };
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    if (!measures(component, true)) continue;
    assumptions.push_back(
        std::string(component) +
        (measures(component, false)
             ? ": published estimator: overhanging strips give the stiffness as if they had no "
               "friction, and it is held while the rolled strips give friction"
             : ": published estimator: without overhanging strips, which it takes the stiffness "
               "from, stiffness is estimated together with friction"));
  }
}

}  // namespace

void warn_of_unmatched_options(const FitOptions& options, StudyResult& result) {
  std::vector<std::string> names;
  for (const auto* estimates : {&result.parameters, &result.nuisance}) {
    for (const ParameterEstimate& estimate : *estimates) names.push_back(estimate.name);
  }
  std::ranges::move(unmatched_options(options, names), std::back_inserter(result.warnings));
}

std::vector<std::string> assumptions_of(const Study& study, const Experiments& experiments) {
  std::vector<std::string> assumptions;
  const bool stretched = std::any_of(experiments.begin(), experiments.end(), [](const auto& e) {
    return e->info().component.starts_with("stretch");
  });
  if (stretched) {
    assumptions.emplace_back(
        "every specimen is stretched uniformly; effects of the clamps on the strain are left out");
  }
  const bool flows = std::ranges::any_of(study.model.components, [](const auto& component) {
    return std::ranges::any_of(component.second.addends, &AddendKind::flows);
  });
  assumptions.emplace_back(
      flows ? "friction depends on the path of strain, not on its speed"
            : "friction depends on the path of strain, not on its speed; no viscosity, no creep");
  for (const auto& experiment : experiments) {
    const ExperimentInfo& info = experiment->info();
    if (!info.test.assumption.empty()) {
      assumptions.push_back(fmt::format("{}: {}", info.name, info.test.assumption));
    } else if (!info.length_noise) {
      assumptions.push_back(
          info.name + ": the noise is in the forces; none is stated for what drives the path");
    }
  }
  if (study.fit.estimator == EstimatorKind::anchor) {
    assumptions.push_back(
        "published estimator: friction saturated at every turning point, its "
        "approximate solution (offset b tau dropped); both bias it");
    add_stiffness_of_rolled_strips(experiments, assumptions);
  }
  return assumptions;
}

}  // namespace pliant
