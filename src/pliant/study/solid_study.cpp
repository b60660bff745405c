#include "pliant/study/solid_study.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/estimate.h"
#include "pliant/estimation/solid/solid_laws.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/experiment/row_times.h"
#include "pliant/experiment/solid_material.h"
#include "pliant/material/material_samples.h"
#include "pliant/study/body_map.h"
#include "pliant/study/body_samples.h"
#include "pliant/study/conclusion.h"
#include "pliant/study/solid_results.h"
#include "pliant/study/stated_branches.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

using SolidExperiments = std::vector<std::unique_ptr<Experiment>>;

bool is_of_solid(const ExperimentSpec& spec) { return spec.test->type().facts.measures_solids; }

SolidExperiments read_solids(const Study& study, StudyResult& result) {
  SolidExperiments experiments;
  for (const ExperimentSpec& spec : study.experiments) {
    const TestType& type = spec.test->type();
    PLIANT_ASSERT(type.make_solid, "tests of solids make experiments");
    experiments.push_back(type.make_solid(spec, DataRows(spec.data)));
    add_remarks(spec.name, experiments.back()->info(), result);
  }
  return experiments;
}

void refuse_sheets(const Study& study) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (is_of_solid(spec)) continue;
    throw InputError(
        spec.where,
        quoted_value(spec.name) + " is of cloth, and others of the study are of a solid",
        "experiments of one of them, in a study each");
  }
}

/// The stretches across are those of least energy, which a material without anything against a
/// change of volume has none of.
void require_volume(const Study& study, bool has_volume) {
  if (has_volume || !is_compressible(study)) return;
  throw InputError({study.file, 0, "model.components"},
                   "nothing in the material resists a change of volume, which experiments with "
                   "`incompressible: false`, or of whole bodies, leave free",
                   "a component `J` or `log-J`");
}

std::vector<const Experiment*> fitted(const Study& study, const SolidExperiments& all) {
  std::vector<const Experiment*> experiments;
  for (const auto& experiment : all) {
    if (experiment->info().role == ExperimentRole::fit) experiments.push_back(experiment.get());
  }
  if (!experiments.empty()) return experiments;
  throw InputError({study.file, 0, "validate"}, "leaves no experiment to be fitted",
                   "at least one that is not under `validate`");
}

void refuse_estimator(const Study& study) {
  if (study.fit.estimator == EstimatorKind::path) return;
  throw InputError({study.file, 0, "fit.estimator"},
                   "the published estimator knows strips of cloth alone", "path");
}

/// What a fit of a solid would not heed.
void refuse_options_of_cloth(const Study& study) {
  require_stated_branches(study);
  if (study.fit.monotone_stress) {
    throw InputError({study.file, 0, "fit.monotone_stress"},
                     "is of cloth: the control values of a solid's spline energies are not "
                     "negative, which makes each convex",
                     "a study of a solid without it (`fit.bounds` for other numbers)");
  }
}

/// What limits and samples are of has to be in the model.
void require_components(const Study& study,
                        const std::map<std::string, ComponentModel>& components) {
  const auto require = [&](const std::string& name, const char* field) {
    if (components.contains(name)) return;
    std::vector<std::string> names;
    for (const auto& [component, model] : components) names.push_back(component);
    throw InputError({study.file, 0, field}, quoted_value(name) + " is no component of the model",
                     list_of_names(names));
  };
  for (const std::vector<std::string>& limit : study.model.limits) {
    for (const std::string& name : limit) require(name, "model.limits");
  }
  if (!study.model.samples) return;
  for (const std::string& name : study.model.samples->of) require(name, "model.samples.of");
}

/// Where a component flows with time, each row that is fitted has one.
void require_times(const Study& study, const std::map<std::string, ComponentModel>& components,
                   const SolidExperiments& experiments) {
  for (const auto& [name, model] : components) {
    if (std::ranges::none_of(model.addends, &AddendKind::flows)) continue;
    for (const auto& experiment : experiments) {
      pliant::require_times(*experiment, {study.file, 0, "model.components." + name + ".addends"});
    }
  }
}

void refuse_samples_in_pieces(const Study& study, const Material& material) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (!spec.test->body()) require_same_everywhere(material, spec.where);
  }
}

/// Of the bodies that are fitted.
int element_count(const Study& study) {
  int elements = 0;
  for (const ExperimentSpec& spec : study.experiments) {
    const VolumeMesh* body = spec.test->body();
    if (body && spec.role == ExperimentRole::fit) elements += body->element_count();
  }
  return elements;
}

/// What is fitted of the study, with bodies of elements half as large; nothing without bodies, or
/// where these would have so many elements that they took longer than the fit.
std::optional<Study> on_finer_bodies(const Study& study) {
  constexpr int kMostElements = 2500;
  const int elements = element_count(study);
  if (elements == 0 || elements > kMostElements) return std::nullopt;
  Study finer = study;
  std::erase_if(finer.experiments,
                [](const ExperimentSpec& spec) { return spec.role != ExperimentRole::fit; });
  for (ExperimentSpec& spec : finer.experiments) {
    if (auto test = spec.test->on_finer_body()) spec.test = std::move(test);
  }
  return finer;
}

const char* about_mesh_error(const SolidFit& fit) {
  return fit.mesh_error.size() > 0
             ? "standard errors contain that of the mesh: by how much the numbers would move on "
               "one of half the edge, and a third of that again"
             : "standard errors do not contain that of the mesh: one of half the edge has too many "
               "elements, or no equilibria";
}

std::vector<std::string> assumptions_of(const Study& study, const SolidExperiments& experiments) {
  std::vector<std::string> assumptions;
  for (const auto& experiment : experiments) {
    const ExperimentInfo& info = experiment->info();
    assumptions.push_back(fmt::format("{}: {}", info.name, info.test.assumption));
  }
  assumptions.emplace_back("no rate dependence, no damage (Mullins effect)");
  assumptions.emplace_back(
      "each experiment counts by its largest stress (or the noise stated of it): what the law "
      "misses is a share of the stress");
  std::ranges::move(stated_options(study.fit), std::back_inserter(assumptions));
  return assumptions;
}

}  // namespace

bool measures_solids(const Study& study) {
  return std::ranges::any_of(study.experiments, is_of_solid);
}

bool is_compressible(const Study& study) {
  return std::ranges::any_of(
      study.experiments, [](const ExperimentSpec& spec) { return spec.test->volume_may_change(); });
}

StudyResult fit_solid_study(const Study& study, const RunContext& context) {
  const Stopwatch watch;
  refuse_sheets(study);
  refuse_estimator(study);
  refuse_options_of_cloth(study);
  StudyResult result = describe(study);
  const SolidExperiments experiments = read_solids(study, result);
  const auto components = solid_components(study.model, is_compressible(study));
  require_volume(study, std::ranges::any_of(components, [](const auto& component) {
                   return !is_isochoric(component.first);
                 }));
  require_components(study, components);
  require_times(study, components, experiments);
  StudyResult told_already;
  const std::optional<Study> finer = on_finer_bodies(study);
  const SolidExperiments on_finer = finer ? read_solids(*finer, told_already) : SolidExperiments();
  const SolidFit fit =
      fit_solid(study, components, body_samples(study), fitted(study, experiments),
                finer ? fitted(*finer, on_finer) : std::vector<const Experiment*>(), context);
  result.assumptions = assumptions_of(study, experiments);
  if (element_count(study) > 0) result.assumptions.emplace_back(about_mesh_error(fit));
  add_solid_fit(fit, result);
  if (is_heterogeneous(fit.material)) result.body = grid_at_rest(*body_of_samples(study));
  std::size_t part = 0;
  for (const auto& experiment : experiments) {
    ExperimentResult row = compare_solid(*experiment, fit.material);
    if (row.role == ExperimentRole::fit) {
      take_noise(fit.uncertainty, part, row, result);
      doubt_rows(fit.uncertainty, part++, row, result.warnings);
    } else {
      row.handled.emplace_back("predicted, the material not fitted to it");
      add_band(fit, *experiment, context, row);
    }
    result.experiments.push_back(std::move(row));
  }
  warn_of_unmatched_options(study.fit, result);
  result.seconds = watch.seconds();
  conclude_fit(study, result);
  return result;
}

StudyResult evaluate_solid_study(const Study& study, const Material& material,
                                 const RunContext& context) {
  const Stopwatch watch;
  refuse_sheets(study);
  if (material.kind != MaterialKind::solid) {
    throw InputError(
        {study.file, 0, "experiments"},
        "are of a solid, and the material " + quoted_value(material.name) + " is cloth",
        "a material of kind `solid`");
  }
  require_volume(study, resists_volume(material));
  refuse_samples_in_pieces(study, material);
  Study predicted = study;
  for (ExperimentSpec& spec : predicted.experiments) spec.role = ExperimentRole::validate;
  StudyResult result = describe(predicted);
  result.material = material;
  if (result.density == 0) result.density = material.density;
  const SolidExperiments experiments = read_solids(predicted, result);
  for (const auto& experiment : experiments) {
    context.stop.throw_if_requested();
    result.experiments.push_back(compare_solid(*experiment, material));
    result.experiments.back().handled.emplace_back("predicted, the material as it is given");
  }
  add_solid_curves(material, nullptr, result);
  result.assumptions = assumptions_of(study, experiments);
  result.seconds = watch.seconds();
  conclude_evaluation(predicted, result);
  return result;
}

}  // namespace pliant
