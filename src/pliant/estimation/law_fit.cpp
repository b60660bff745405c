#include "pliant/estimation/law_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/estimation/linear_start.h"
#include "pliant/estimation/monotone_stress.h"

namespace pliant {
namespace {

constexpr int kMostLinearStarts = 3;
constexpr double kReachedShare = 1e-3;
constexpr double kExactRms = 1e-4;  // of the noise first assumed: as good as exact

/// How far a search goes.
struct Effort {
  double tolerance;  // of the cost
  int iterations;
};
constexpr Effort kTrial{1e-6, 50}, kRough{1e-4, 15};

// A trial tells where a start leads; only the best is followed to the end.
LeastSquaresOptions trial(double best_cost, const Effort& effort) {
  constexpr double kHopeless = 100;
  LeastSquaresOptions options;
  options.max_iterations = effort.iterations;
  options.function_tolerance = effort.tolerance;
  options.hopeless_cost = kHopeless * best_cost;
  options.patience = 4;
  return options;
}

// Parameters to a small share of their standard errors, or exact where the data are.
LeastSquaresOptions finish() {
  LeastSquaresOptions options;
  options.function_tolerance = 1e-10;
  return options;
}

std::vector<ComponentLaw> starting_laws(const ComponentProblem& problem, const ComponentLaw& shape,
                                        const std::vector<ComponentLaw>& extra) {
  std::vector<ComponentLaw> laws;
  for (const LinearStart& start : linear_starts(problem, shape, kMostLinearStarts)) {
    laws.push_back(start.law);
  }
  if (shape.friction_law == FrictionLaw::dahl) {
    const ComponentLaw first = laws.front();
    for (const double factor : {0.3, 3.0}) {
      laws.push_back(linear_start(problem, first, factor * first.friction[2]).law);
    }
  }
  laws.insert(laws.end(), extra.begin(), extra.end());
  return laws;
}

Eigen::VectorXd start_vector(const ComponentLaw& law, const LawFit& fit) {
  Eigen::VectorXd all = starts_of(fit.unknowns);
  all.head(law.parameter_count()) = law.parameters();
  return all;
}

// Of what counts, and of priors.
int residual_count(const Problem& problem) {
  return problem.rows() + static_cast<int>(problem.priors().size());
}

void take_solution(LawFit& fit, const ComponentLaw& shape, const LeastSquaresSummary& solution,
                   int residuals) {
  fit.solution = solution;
  fit.law = shape.with_parameters(solution.parameters);
  fit.nuisance = solution.parameters.tail(solution.parameters.size() - shape.parameter_count());
  fit.rms = std::sqrt(2 * solution.cost / std::max(residuals - free_count(fit.unknowns), 1));
}

LawFit best_trial(const ComponentProblem& problem, const ComponentLaw& shape,
                  const FitOptions& options, const std::vector<ComponentLaw>& extra,
                  const Effort& effort) {
  LawFit fit;
  fit.law = shape;
  fit.unknowns = problem.unknowns(shape, options);
  fit.monotone_stress = options.monotone_stress;
  const Problem rows = problem_of(problem, fit);
  const LeastSquaresProblem least_squares = rows.least_squares();
  const double exact = residual_count(rows) * kExactRms * kExactRms / 2;
  std::vector<double> costs;
  LeastSquaresSummary best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const ComponentLaw& law : starting_laws(problem, shape, extra)) {
    const LeastSquaresSummary solution =
        solve_least_squares(least_squares, start_vector(law, fit),
                            trial(std::max(best.cost, exact), effort), problem.stop());
    costs.push_back(solution.cost);
    if (solution.cost < best.cost || best.parameters.size() == 0) best = solution;
  }
  take_solution(fit, shape, best, residual_count(rows));
  const int degrees = std::max(residual_count(rows) - free_count(fit.unknowns), 1);
  for (const double cost : costs) {
    fit.start_ends.push_back(std::sqrt(2 * cost / degrees));
    if (cost <= best.cost * (1 + kReachedShare) + exact) ++fit.starts_reached;
  }
  return fit;
}

}  // namespace

Problem problem_of(const ComponentProblem& problem, const LawFit& fit) {
  Problem rows = problem.problem(fit.law, fit.unknowns);
  if (!fit.monotone_stress) return rows;
  const Eigen::MatrixXd tangents = elastic_tangents(fit.law.stiffness, problem.largest_strain());
  Eigen::MatrixXd not_negative =
      Eigen::MatrixXd::Zero(tangents.rows(), static_cast<Eigen::Index>(fit.unknowns.size()));
  not_negative.leftCols(tangents.cols()) = tangents;
  rows.set_not_negative(std::move(not_negative));
  return rows;
}

const std::string& component_of(const ComponentProblem& problem) {
  return problem.experiments().front()->info().component;
}

LawFit fit_law(const ComponentProblem& problem, const ComponentLaw& shape,
               const FitOptions& options, const std::vector<ComponentLaw>& extra) {
  return refit(problem, best_trial(problem, shape, options, extra, kTrial));
}

LawFit fit_law_roughly(const ComponentProblem& problem, const ComponentLaw& shape,
                       const FitOptions& options, const std::vector<ComponentLaw>& extra) {
  return best_trial(problem, shape, options, extra, kRough);
}

LawFit refit(const ComponentProblem& problem, const LawFit& fit) {
  LawFit again = fit;
  const Problem rows = problem_of(problem, fit);
  take_solution(
      again, fit.law,
      solve_least_squares(rows.least_squares(), fit.solution.parameters, finish(), problem.stop()),
      residual_count(rows));
  return again;
}

LawFit reweighed(const ComponentProblem& problem, const LawFit& fit) {
  LawFit again = fit;
  const Problem rows = problem_of(problem, fit);
  const LeastSquaresProblem least_squares = rows.least_squares();
  Eigen::VectorXd residual(least_squares.residuals);
  if (!least_squares.evaluate(fit.solution.parameters, residual, nullptr)) return again;
  LeastSquaresSummary solution = fit.solution;
  solution.cost = residual.squaredNorm() / 2;
  take_solution(again, fit.law, solution, residual_count(rows));
  return again;
}

}  // namespace pliant
