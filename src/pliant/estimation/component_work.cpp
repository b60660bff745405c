#include "pliant/estimation/component_work.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/estimate.h"
#include "pliant/estimation/experiment_result.h"
#include "pliant/estimation/law_comparison.h"
#include "pliant/estimation/nuisance_warnings.h"
#include "pliant/estimation/residual_warnings.h"
#include "pliant/experiment/strain_words.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/fill.h"
#include "pliant/material/snapping_strains.h"

namespace pliant {
namespace {

void add_parameters(const ComponentWork& work, StudyResult& result) {
  const ComponentFit& fit = work.fit;
  const int law_count = fit.fit.law.parameter_count();
  for (Eigen::Index i = 0; i < fit.fit.solution.parameters.size(); ++i) {
    ParameterEstimate estimate =
        estimate_of(fit.fit.unknowns, fit.fit.solution.parameters, fit.uncertainty, i);
    estimate.limit = fit.limits[static_cast<size_t>(i)];
    if (i < law_count) {
      const auto& specimens = fit.specimens[static_cast<size_t>(i)];
      if (specimens) estimate.between_specimen_sd = specimens->between_sd;
      const std::optional<double> strain = fit.fit.unknowns[static_cast<size_t>(i)].strain;
      if (strain) {
        estimate.note = "at " + strain_in_words(work.component, *strain, result.material.membrane);
      }
      if (estimate.limit) {
        const bool upper = *estimate.limit > estimate.value;
        estimate.note +=
            fmt::format("{}{} {:.3g} {} (95 %, one-sided)", estimate.note.empty() ? "" : "; ",
                        upper ? "below" : "above", *estimate.limit, estimate.unit);
      }
      if (fit.rests.shift.size() > 0 && !estimate.fixed) {
        estimate.note += fmt::format("{}{:.2g} of the error by strips of several rests",
                                     estimate.note.empty() ? "" : "; ", fit.rests.shift(i));
      }
      result.parameters.push_back(estimate);
    } else {
      result.nuisance.push_back(estimate);
    }
  }
}

void add_experiments(const ComponentWork& work, StudyResult& result) {
  const ComponentFit& fit = work.fit;
  for (size_t e = 0; e < work.fitted.size(); ++e) {
    const ComponentExperiment& experiment = *work.fitted[e];
    const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
    const int first = work.problem->first_nuisance(e);
    ExperimentResult row = compare(experiment, fit.fit.law, fit.fit.nuisance.segment(first, count));
    take_noise(fit.uncertainty, e, row, result);
    doubt_rows(fit.uncertainty, e, row, result.warnings);
    if (fit.elastic) {
      add_elastic(row, experiment, fit.elastic->law, fit.elastic->nuisance.segment(first, count));
    }
    std::ranges::move(residual_warnings(row, experiment.path()),
                      std::back_inserter(result.warnings));
    result.experiments.push_back(std::move(row));
  }
  for (const ComponentExperiment* experiment : work.validated) {
    const Eigen::VectorXd nuisance = experiment->unfitted_nuisance(fit.fit.law);
    try {
      ExperimentResult row = compare(*experiment, fit.fit.law, nuisance);
      row.handled.push_back(unfitted_note(experiment->info(), "the material not fitted to it"));
      if (fit.elastic) add_elastic(row, *experiment, fit.elastic->law, nuisance);
      result.experiments.push_back(std::move(row));
    } catch (const SolverError& error) {
      result.warnings.push_back(error.what());
    }
  }
}

void add_warnings(const ComponentWork& work, StudyResult& result) {
  const ComponentFit& fit = work.fit;
  if (!fit.fit.solution.converged) {
    result.converged = false;
    const LeastSquaresSummary& end = fit.fit.solution;
    result.warnings.push_back(
        fmt::format("the fit of {} did not converge: {}", work.component,
                    std::isfinite(end.cost)
                        ? fmt::format("its search stopped after {} iterations", end.iterations)
                        : "its law cannot carry the loads"));
  }
  for (Eigen::Index i = 0; i < fit.fit.law.parameter_count(); ++i) {
    const auto index = static_cast<size_t>(i);
    const std::string& name = fit.fit.unknowns[index].name;
    if (fit.uncertainty.at_bound[index]) {
      result.undetermined.push_back(name + " (the data pushes it to its bound)");
    } else if (fit.uncertainty.determination[index] == Determination::none &&
               !fit.fit.unknowns[index].fixed) {
      const bool interval = std::isfinite(fit.uncertainty.std_error(i));
      result.undetermined.push_back(
          name + (interval ? " (its 95 % interval includes zero)" : " (the data leaves it free)"));
    }
  }
  const auto added = std::ssize(fit.fit.law.addends) - std::ssize(work.plan.addends);
  if (work.plan.branches_stated && added + 1 < work.plan.branches) {
    result.undetermined.push_back(
        fmt::format("{} of {} branches of friction of {} (a further one explains no more than "
                    "chance does)",
                    work.plan.branches - added - 1, work.plan.branches, work.component));
  }
}

// Settings of the rolled strips whose cylinders bent them no further than a law snaps.
int snapping_strips(const ComponentWork& work, const StrainInterval& snapping) {
  int count = 0;
  for (const ComponentExperiment* experiment : work.fitted) {
    if (!experiment->info().test.is_released) continue;
    const MeasuredPath& path = experiment->path();
    for (size_t i = 0; i < path.strain.size(); ++i) {
      const double strain = std::abs(path.strain[i]);
      count += path.starts_flat[i] && strain > snapping.from && strain < snapping.to;
    }
  }
  return count;
}

// Where a strip jumps to is not the law's alone to say.
void warn_of_snapping(const ComponentWork& work, StudyResult& result) {
  const ComponentLaw& law = work.fit.fit.law;
  if (law.friction_law != FrictionLaw::dahl || law.addends_remember()) return;
  for (const StrainInterval& snapping : snapping_strains(law, 1, work.problem->largest_strain())) {
    const int strips = snapping_strips(work, snapping);
    if (strips == 0) continue;
    result.warnings.push_back(fmt::format(
        "the fitted law of {} snaps on unloading at curvatures of {:.3g} to {:.3g} 1/m: {} "
        "profiles of strips that were rolled to there jumped on their release, and what they say "
        "of the law hangs on how; compare a fit without them",
        work.component, snapping.from / kStrainPerCurvature, snapping.to / kStrainPerCurvature,
        strips));
  }
}

// How large the strains of the fitted experiments are by the fitted law; somewhere along it a bent
// strip is straight.
std::pair<double, double> strains_of_data(const ComponentWork& work) {
  std::pair<double, double> range{is_bending(work.component) ? 0 : INFINITY, 0};
  for (size_t e = 0; e < work.fitted.size(); ++e) {
    const ComponentExperiment& experiment = *work.fitted[e];
    const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
    const auto [low, high] =
        compare(experiment, work.fit.fit.law,
                work.fit.fit.nuisance.segment(work.problem->first_nuisance(e), count))
            .strain_range;
    const double least = low < 0 && high > 0 ? 0 : std::min(std::abs(low), std::abs(high));
    range.first = std::min(range.first, least);
    range.second = std::max({range.second, std::abs(low), std::abs(high)});
  }
  return range;
}

MaterialComponent measured_component(const ComponentWork& work) {
  MaterialComponent component;
  set_law(component, work.fit.fit.law);
  component.range = strains_of_data(work);
  return component;
}

}  // namespace

void add_component(const ComponentWork& work, StudyResult& result) {
  add_parameters(work, result);
  add_experiments(work, result);
  add_warnings(work, result);
  result.assumptions.insert(result.assumptions.end(), work.apparatus.begin(), work.apparatus.end());
  warn_of_snapping(work, result);
  if (work.plan.fit.estimator != EstimatorKind::anchor) {
    std::ranges::move(nuisance_warnings(*work.problem, work.fit),
                      std::back_inserter(result.warnings));
  }
  std::ranges::copy(work.lengths, std::back_inserter(result.warnings));
  std::ranges::copy(work.fit.rests.warnings, std::back_inserter(result.warnings));
  result.curves.push_back(component_curve(work.component, work.fit.fit.law,
                                          strains_of_data(work).second,
                                          errors_of_law(work.fit.uncertainty, 0)));
  result.stages.insert(result.stages.end(), work.fit.stages.begin(), work.fit.stages.end());
  add_starts(work.fit.fit.starts, result);
  result.singular_values[work.component] = work.fit.uncertainty.singular_values;
  result.models.insert(result.models.end(), work.models.begin(), work.models.end());
  std::ranges::move(law_advice(work.models), std::back_inserter(result.warnings));
  result.profiles.insert(result.profiles.end(), work.profiles.begin(), work.profiles.end());
}

void add_figures(const ComponentWork& work, const Material& material, StudyResult& result) {
  std::ranges::move(lab_figures(material, work.component, errors_of_law(work.fit.uncertainty, 0)),
                    std::back_inserter(result.figures));
}

Eigen::MatrixXd joint_covariance(const std::vector<ComponentWork>& works) {
  std::vector<std::pair<const Uncertainty*, Eigen::Index>> order;
  for (const bool law : {true, false}) {
    for (const ComponentWork& work : works) {
      if (!work.problem) continue;
      const Eigen::Index law_count = work.fit.fit.law.parameter_count();
      const Eigen::Index count = work.fit.fit.solution.parameters.size();
      for (Eigen::Index i = law ? 0 : law_count; i < (law ? law_count : count); ++i) {
        order.emplace_back(&work.fit.uncertainty, i);
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(order.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      const auto& [one, row] = order[static_cast<size_t>(i)];
      const auto& [other, column] = order[static_cast<size_t>(j)];
      if (one == other) covariance(i, j) = one->covariance(row, column);
    }
  }
  return covariance;
}

Material material_of(const FitSettings& settings, const std::vector<ComponentWork>& works) {
  Material material;
  material.name = settings.name;
  material.density = settings.density;
  material.membrane = settings.model.membrane;
  material.bending = settings.model.bending;
  for (const std::string& name : sheet_component_names()) {
    material.components[name] = {{}, {}, ComponentStatus::unmeasured, {}};
  }
  for (const ComponentWork& work : works) {
    if (work.problem) material.components[work.component] = measured_component(work);
  }
  return material;
}

}  // namespace pliant
