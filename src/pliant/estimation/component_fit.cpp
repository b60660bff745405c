#include "pliant/estimation/component_fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/anchor_estimator.h"
#include "pliant/estimation/law_growth.h"
#include "pliant/estimation/linear_start.h"
#include "pliant/estimation/profile_likelihood.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/experiment/row_times.h"

namespace pliant {
namespace {

constexpr int kNoiseRounds = 5;
constexpr int kLossRounds = 30;  // a robust loss is followed by weights alone
constexpr double kNoiseSettled = 0.01;

using FittedExperiments = std::vector<const ComponentExperiment*>;

bool are_of_one_type(const FittedExperiments& experiments) {
  return std::ranges::all_of(experiments, [&](const ComponentExperiment* experiment) {
    return experiment->info().type == experiments.front()->info().type;
  });
}

// A type alone has its own default. Where sparse data of several types come together one of them
// may ask for the published stiffness k1 + k2 |strain|.
CurveKind default_stiffness(const FittedExperiments& experiments) {
  if (are_of_one_type(experiments)) return experiments.front()->info().test.stiffness;
  const bool sparse = std::ranges::all_of(
      experiments, [](const auto* experiment) { return experiment->info().test.is_sparse; });
  const bool published = std::ranges::any_of(experiments, [](const auto* experiment) {
    return experiment->info().test.stiffness == CurveKind::affine;
  });
  return sparse && published ? CurveKind::affine : CurveKind::hermite;
}

ComponentLaw shape_of(const ComponentPlan& plan, const ComponentProblem& problem) {
  ComponentLaw shape = plan.form();
  if (plan.stiffness == CurveKind::constant) shape.stiffness = ScalarCurve::constant(0);
  if (plan.stiffness == CurveKind::affine) shape.stiffness = ScalarCurve::affine(0, 0);
  if (plan.stiffness == CurveKind::hermite) {
    // Equidistant over the data: the thesis' placement, for the published estimator.
    std::vector<double> knots;
    for (int i = 0; i < plan.fit.control_points; ++i) {
      knots.push_back(problem.largest_strain() * i / std::max(plan.fit.control_points - 1, 1));
    }
    shape.stiffness = ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0),
                                           is_even(component_of(problem)));
  }
  return shape;
}

bool needs_noise_rounds(const ComponentProblem& problem, const LawFit& fit) {
  if (problem.loss() != RobustLoss::none) return true;
  const bool length_noise =
      std::any_of(problem.experiments().begin(), problem.experiments().end(),
                  [](const ComponentExperiment* experiment) {
                    return experiment->info().length_noise && !experiment->info().measures_length();
                  });
  // A prior is weighed against the noise of the data.
  const bool prior = std::any_of(fit.unknowns.begin(), fit.unknowns.end(),
                                 [](const Unknown& unknown) { return unknown.prior.has_value(); });
  return length_noise || prior || problem.experiments().size() > 1;
}

// Weights and solution depend on each other where several experiments or both channels carry noise.
void settle_noise(ComponentProblem& problem, LawFit& fit) {
  const int rounds = problem.loss() == RobustLoss::none ? kNoiseRounds : kLossRounds;
  for (int round = 0; round < rounds; ++round) {
    const double change =
        problem.take_noise(measure_noise(problem_of(problem, fit), fit.solution.parameters));
    if (!needs_noise_rounds(problem, fit)) {
      fit = reweighed(problem, fit);
      return;
    }
    fit = refit(problem, fit);  // its cost is in units of the new noise from here on
    if (change < kNoiseSettled) return;
  }
}

// Rows far off are told by a law found without iteration, or they would choose the starts and the
// form of the curve.
void weigh_by_first_law(const ComponentPlan& plan, ComponentProblem& problem) {
  const ComponentLaw law = linear_starts(problem, shape_of(plan, problem), 1).front().law;
  const std::vector<Unknown> unknowns = problem.unknowns(law, plan.fit);
  const Problem rows = problem.problem(law, unknowns);
  try {
    problem.take_noise(measure_noise(rows, starts_of(unknowns)));
  } catch (const SolverError&) {
    // It cannot carry the loads: all rows count alike to begin with.
  }
}

// Fits to single specimens: how much the material varies, and so how well its mean is known.
// Specimens are those that the data of one experiment tells apart: two experiments may have had the
// same strip.
void add_specimens(const ComponentProblem& problem, ComponentFit& result) {
  const LawFit& fit = result.fit;
  const auto parameters = static_cast<size_t>(fit.law.parameter_count());
  std::vector<SpecimenFits> fits(parameters);
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const auto specimens = problem.experiments()[e]->info().specimens.size();
    if (specimens < 2) continue;
    for (size_t s = 0; s < specimens; ++s) {
      const ComponentProblem one = problem.restricted_to(e, static_cast<int>(s));
      if (one.used_rows() <= fit.law.parameter_count()) continue;
      const LawFit own = refit(one, fit);
      const Uncertainty known = estimate_uncertainty(one, own);
      for (size_t i = 0; i < parameters; ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        fits[i].value.push_back(own.solution.parameters(index));
        fits[i].variance.push_back(known.covariance(index, index));
      }
    }
  }
  for (size_t i = 0; i < parameters; ++i) result.specimens.push_back(specimen_spread(fits[i]));
  raise_errors(result);
}

// One-sided limits of the unknowns of the law that the data pushes to their bounds.
std::vector<std::optional<double>> limits_at_bounds(const ComponentProblem& problem,
                                                    const ComponentFit& component) {
  const LawFit& fit = component.fit;
  std::vector<std::optional<double>> limits(fit.unknowns.size());
  for (Eigen::Index u = 0; u < fit.law.parameter_count(); ++u) {
    const auto index = static_cast<size_t>(u);
    if (!component.uncertainty.at_bound[index]) continue;
    limits[index] = limit_at_bound(problem, fit, component.uncertainty, u);
  }
  return limits;
}

// The moments of a buckled strip come from a force whose zero is not known without a fit; what is
// left of rolled strips' samples must tell friction's three parameters.
void refuse_anchors(const FitSettings& settings,
                    const std::vector<const ComponentExperiment*>& experiments) {
  constexpr int kFewest = 3;
  if (settings.fit.estimator != EstimatorKind::anchor) return;
  const Location where{settings.file, 0, "fit.estimator"};
  if (settings.fit.monotone_stress) {
    throw InputError(where, "the published estimator knows no monotone_stress", "path");
  }
  if (settings.fit.loss != RobustLoss::none) {
    throw InputError(where, "the published estimator minimises squares and knows no loss", "path");
  }
  for (const ComponentExperiment* experiment : experiments) {
    const std::string name = quoted_value(experiment->info().name);
    const std::vector<char>& sampled = experiment->path().published_samples;
    for (const NuisanceParameter& nuisance : experiment->nuisance()) {
      if (!nuisance.name.ends_with(".slip") && !nuisance.name.ends_with(".compliance")) continue;
      throw InputError(where, "the published estimator does not look for " + nuisance.name,
                       "path, or numbers for `slip` and `compliance`");
    }
    if (experiment->info().test.has_unknown_zero) {
      throw InputError(
          where, "the published estimator knows no moments of the buckled strip " + name, "path");
    }
    if (!experiment->info().test.is_released ||
        std::count(sampled.begin(), sampled.end(), 1) >= kFewest) {
      continue;
    }
    throw InputError(where,
                     "the published estimator leaves out where the weight bends a strip further "
                     "that its stiffness opens, which is nearly all of " +
                         name,
                     "path, or strips that were rolled to the left, against their weight");
  }
}

// Strips that bend under their weight are followed with what their profile's history holds.
void refuse_addends(const FitSettings& settings,
                    const std::vector<const ComponentExperiment*>& experiments,
                    const ComponentPlan& plan) {
  const std::string& component = experiments.front()->info().component;
  const Location where{settings.file, 0, "model.components." + component + ".addends"};
  if (!plan.addends.empty() && settings.fit.estimator == EstimatorKind::anchor) {
    throw InputError(where, "the published estimator knows stiffness and friction alone", "none");
  }
  if (plan.form().flows()) {
    for (const ComponentExperiment* experiment : experiments) require_times(*experiment, where);
  }
}

/// How many branches of friction there may be.
void plan_branches(const FrictionModel& asked, const FitSettings& settings, ComponentPlan& plan) {
  constexpr int kMostBranches = 4;
  if (plan.friction == FrictionLaw::none || asked.branches == 1) return;
  if (settings.fit.estimator == EstimatorKind::anchor) {
    throw InputError({settings.file, 0, "model.friction"},
                     "the published estimator knows one branch of friction", "dahl");
  }
  plan.branches_stated = asked.branches > 0;
  plan.branches = plan.branches_stated ? asked.branches : kMostBranches;
}

void refuse_energies(const FitSettings& settings, const std::string& component, CurveKind kind) {
  if (kind != CurveKind::spline && kind != CurveKind::energy) return;
  throw InputError(
      {settings.file, 0, "model.components." + component + ".stiffness"},
      fmt::format("is `{}`, and in one dimension strips are fitted with the curve of a "
                  "stiffness",
                  name_of(kind)),
      "hermite, affine or constant, or `model: {strips: sheet}`");
}

// What growth has tried: "3 control points, 2 branches".
std::string stage_name(const ComponentPlan& plan, const GrowthStage& stage) {
  const auto counted = [](int count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
  };
  std::string name;
  if (plan.stiffness == CurveKind::hermite) {
    name = counted(stage.control_points, "control point", "control points");
  } else if (plan.stiffness == CurveKind::none) {
    name = "addends alone";
  } else {
    name = fmt::format("{} stiffness", name_of(plan.stiffness));
  }
  if (plan.branches > 1) name += ", " + counted(stage.branches, "branch", "branches");
  return name;
}

}  // namespace

ComponentLaw ComponentPlan::form() const {
  ComponentLaw form{ScalarCurve::none(), friction};
  for (const AddendKind* kind : addends) {
    form.addends.emplace_back(*kind, Eigen::VectorXd::Ones(std::ssize(kind->parameters)));
  }
  return form;
}

void raise_errors(ComponentFit& component) {
  for (size_t i = 0; i < component.specimens.size(); ++i) {
    if (!component.specimens[i]) continue;
    raise_error(component.uncertainty, static_cast<Eigen::Index>(i), *component.specimens[i],
                component.fit);
  }
}

ComponentPlan plan_component(const FitSettings& settings,
                             const std::vector<const ComponentExperiment*>& experiments,
                             std::vector<std::string>& notes) {
  const std::string& component = experiments.front()->info().component;
  ComponentModel model;
  const auto found = settings.model.components.find(component);
  if (found != settings.model.components.end()) model = found->second;

  ComponentPlan plan;
  plan.fit = settings.fit;
  refuse_anchors(settings, experiments);
  plan.addends = model.addends;
  refuse_addends(settings, experiments, plan);
  plan.stiffness =
      model.stiffness.value_or(settings.model.stiffness.value_or(default_stiffness(experiments)));
  refuse_energies(settings, component, plan.stiffness);
  const std::string_view undetermined = experiments.front()->info().test.undetermined;
  if (are_of_one_type(experiments) && !undetermined.empty()) {
    notes.push_back(fmt::format("stiffness of {} {}", component, undetermined));
  }
  const FrictionModel asked = friction_of(settings.model, component);
  const FrictionChoice choice = asked.choice;
  const bool data_unloads = any_unloads(experiments);
  if (choice == FrictionChoice::none) plan.friction = FrictionLaw::none;
  if (!data_unloads && choice != FrictionChoice::none) {
    notes.push_back("friction of " + component +
                    ": the data only loads; friction shows when it unloads");
    if (choice == FrictionChoice::automatic) plan.friction = FrictionLaw::none;
  }
  plan_branches(asked, settings, plan);
  for (const AddendKind* kind : plan.addends) {
    if (data_unloads || kind->flows || !remembers(*kind)) continue;
    notes.push_back(
        fmt::format("{} of {}: the data only loads; what strain leaves behind shows when "
                    "it returns",
                    kind->name, component));
  }
  return plan;
}

FormFit fit_form(const ComponentProblem& problem, const ComponentPlan& plan) {
  const std::string& component = component_of(problem);
  FormFit result;
  const bool points_grow = plan.stiffness == CurveKind::hermite;
  const GrowthLimits limits{points_grow ? plan.fit.control_points : 0, plan.branches};
  const ComponentLaw form = points_grow ? plan.form() : shape_of(plan, problem);
  GrownFit grown = grow_law(problem, form, limits, plan.fit);
  for (const GrowthStage& stage : grown.stages) {
    result.stages.push_back({component, stage_name(plan, stage), unit_of_residuals(problem),
                             stage.rms, stage.accepted});
  }
  if (points_grow || plan.branches > 1) result.stages.back().ended = name_of(grown.end);
  result.fit = std::move(grown.fit);
  return result;
}

ComponentFit fit_component(ComponentProblem& problem, const ComponentPlan& plan) {
  ComponentFit result;
  result.component = component_of(problem);
  if (plan.fit.estimator == EstimatorKind::anchor) {
    AnchorFit anchor = fit_anchor(problem, shape_of(plan, problem), plan.fit);
    for (const AnchorStage& stage : anchor.stages) {
      result.stages.push_back({result.component, stage.name, "N", stage.rms_force, true});
    }
    result.fit = std::move(anchor.fit);
    result.uncertainty = estimate_anchor_uncertainty(problem, result.fit);
  } else {
    if (problem.loss() != RobustLoss::none) weigh_by_first_law(plan, problem);
    FormFit form = fit_form(problem, plan);
    result.fit = better_by_rests(problem, form.fit);
    result.stages = std::move(form.stages);
    settle_noise(problem, result.fit);
    result.uncertainty = estimate_uncertainty(problem, result.fit);
    result.rests = influence_of_rests(problem, result.fit, result.uncertainty.std_error);
    if (result.rests.shift.size() > 0) {
      add_systematic(result.rests.shift, result.fit.unknowns, result.fit.solution.parameters,
                     result.uncertainty);
    }
    add_specimens(problem, result);
    result.limits = limits_at_bounds(problem, result);
  }
  result.specimens.resize(static_cast<size_t>(result.fit.law.parameter_count()));
  result.limits.resize(result.fit.unknowns.size());
  if (result.fit.law.remembers()) {
    const ComponentLaw elastic = result.fit.law.elastic_part();
    result.elastic = fit_law_roughly(problem, elastic, plan.fit, {{elastic}});
  }
  return result;
}

}  // namespace pliant
