#include "pliant/estimation/anchor_estimator.h"

#include <algorithm>
#include <cmath>

#include "pliant/estimation/anchor_predictor.h"
#include "pliant/estimation/linear_start.h"

namespace pliant {
namespace {

constexpr double kVerySmallTau = 1e-3;  // share of the largest strain

// The problem of the published estimator, in newtons. Unknowns outside [first, last) are held.
Problem force_problem(const ComponentProblem& problem, const ComponentLaw& shape,
                      std::vector<Unknown> unknowns, const Eigen::VectorXd& values, int first,
                      int last) {
  std::vector<ProblemPart> parts;
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const std::vector<char>& used = problem.used(e);
    const Eigen::VectorXd weight = Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>(
                                       used.data(), static_cast<Eigen::Index>(used.size()))
                                       .cast<double>();
    const ComponentExperiment& experiment = *problem.experiments()[e];
    parts.push_back({&experiment, anchor_predictor(experiment, shape), weight,
                     /*takes_stated_noise=*/false});
  }
  for (int i = 0; i < static_cast<int>(unknowns.size()); ++i) {
    if (i < first || i >= last) unknowns[static_cast<size_t>(i)].hold(values(i));
  }
  return {std::move(parts), std::move(unknowns), {}};
}

// The rows that give the stiffness and those that give friction: all of them give both, unless
// strips were hung for the one and rolled for the other.
struct PublishedRows {
  bool stiffness_apart = false;
  ComponentProblem of_stiffness, of_friction;
};

PublishedRows published_rows(const ComponentProblem& problem) {
  const auto& experiments = problem.experiments();
  const auto has = [&](bool overhang) {
    return std::any_of(experiments.begin(), experiments.end(),
                       [&](const ComponentExperiment* experiment) {
                         return experiment->info().test.overhangs == overhang;
                       });
  };
  const bool apart = has(true) && has(false);
  const auto rows_of = [&](bool overhang) {
    return problem.restricted_to([&](size_t e, size_t row) {
      const std::vector<char>& sampled = experiments[e]->path().published_samples;
      const bool belongs = !apart || experiments[e]->info().test.overhangs == overhang;
      return belongs && (sampled.empty() || sampled[row]);
    });
  };
  return {apart, rows_of(true), rows_of(false)};
}

// Linearised with the parameters outside [first, last) held at their values.
Uncertainty stage_uncertainty(const ComponentProblem& problem, const LawFit& fit, int first,
                              int last) {
  const Eigen::VectorXd& values = fit.solution.parameters;
  return uncertainty_of(force_problem(problem, fit.law, fit.unknowns, values, first, last), values);
}

// That of the first parameters by one stage, and of the others by another.
Uncertainty joined(Uncertainty result, const Uncertainty& others, int first) {
  const Eigen::Index count = result.std_error.size() - first;
  result.covariance += others.covariance;
  result.std_error.tail(count) = others.std_error.tail(count);
  result.half_width.tail(count) = others.half_width.tail(count);
  std::copy(others.at_bound.begin() + first, others.at_bound.end(),
            result.at_bound.begin() + first);
  std::copy(others.determination.begin() + first, others.determination.end(),
            result.determination.begin() + first);
  Eigen::VectorXd singular_values(result.singular_values.size() + others.singular_values.size());
  singular_values << result.singular_values, others.singular_values;
  result.singular_values = singular_values;
  return result;
}

}  // namespace

AnchorFit fit_anchor(const ComponentProblem& problem, const ComponentLaw& shape,
                     const FitOptions& options) {
  const PublishedRows rows = published_rows(problem);
  AnchorFit result;
  LawFit& fit = result.fit;
  fit.unknowns = unknowns_of(shape, {component_of(problem)},
                             {problem.peak_stress(), problem.largest_strain()});
  apply_options(options, fit.unknowns);

  const int stiffness = shape.stiffness.size();
  const int count = shape.parameter_count();
  ComponentLaw elastic = shape;
  elastic.friction_law = FrictionLaw::none;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
  values.head(stiffness) = linear_start(rows.of_stiffness, elastic, 1).law.parameters();
  if (shape.friction_law == FrictionLaw::dahl) {
    values(stiffness + 2) = kVerySmallTau * problem.largest_strain();
  }

  const auto run = [&](const ComponentProblem& part, const std::string& name, int first, int last) {
    const Problem stage = force_problem(part, shape, fit.unknowns, values, first, last);
    const LeastSquaresSummary solution =
        solve_least_squares(stage.least_squares(), values, {}, part.stop());
    values = solution.parameters;
    fit.solution = solution;
    result.stages.push_back({name, std::sqrt(2 * solution.cost / part.used_rows())});
  };
  run(rows.of_stiffness, "stiffness without friction", 0, stiffness);
  if (shape.friction_law == FrictionLaw::dahl) {
    const int first = rows.stiffness_apart ? stiffness : 0;
    run(rows.of_friction, "maximum friction with a very small tau", first, stiffness + 2);
    values(stiffness + 2) = 0.05 * problem.largest_strain();
    run(rows.of_friction, "tau", stiffness + 2, count);
    run(rows.of_friction, rows.stiffness_apart ? "friction together" : "all together", first,
        count);
  }
  fit.law = shape.with_parameters(values);
  fit.nuisance.resize(problem.nuisance_count());
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const Eigen::VectorXd nuisance = problem.experiments()[e]->unfitted_nuisance(fit.law);
    fit.nuisance.segment(problem.first_nuisance(e), nuisance.size()) = nuisance;
  }
  fit.rms = result.stages.back().rms_force;
  fit.starts = {component_of(problem), "law", "N", {fit.rms}, 1};
  return result;
}

Uncertainty estimate_anchor_uncertainty(const ComponentProblem& problem, const LawFit& fit) {
  const PublishedRows rows = published_rows(problem);
  const int stiffness = fit.law.stiffness.size();
  const int count = fit.law.parameter_count();
  if (!rows.stiffness_apart) return stage_uncertainty(rows.of_stiffness, fit, 0, count);
  LawFit elastic = fit;
  if (count > stiffness) elastic.solution.parameters.segment<2>(stiffness).setZero();  // a and b
  return joined(stage_uncertainty(rows.of_stiffness, elastic, 0, stiffness),
                stage_uncertainty(rows.of_friction, fit, stiffness, count), stiffness);
}

}  // namespace pliant
