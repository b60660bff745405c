#include "pliant/estimation/law_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/estimation/linear_start.h"

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
    const double tau = laws.front().friction[2];
    for (const double factor : {0.3, 3.0}) {
      laws.push_back(linear_start(problem, shape, factor * tau).law);
    }
  }
  laws.insert(laws.end(), extra.begin(), extra.end());
  return laws;
}

ParameterLimits limits_of(const ComponentProblem& problem, const ComponentLaw& shape,
                          const FitOptions& options) {
  const DataScale scale{problem.peak_stress(), problem.largest_strain()};
  return parameter_limits(shape, component_of(problem), problem.nuisance(), scale, options);
}

Eigen::VectorXd start_vector(const ComponentLaw& law, const Eigen::VectorXd& nuisance) {
  Eigen::VectorXd all(law.parameter_count() + nuisance.size());
  all << law.parameters(), nuisance;
  return all;
}

Eigen::VectorXd nuisance_start(const ComponentProblem& problem) {
  const std::vector<NuisanceParameter> parameters = problem.nuisance();
  Eigen::VectorXd start(static_cast<Eigen::Index>(parameters.size()));
  for (size_t i = 0; i < parameters.size(); ++i) {
    start(static_cast<Eigen::Index>(i)) = parameters[i].start;
  }
  return start;
}

void take_solution(LawFit& fit, const ComponentLaw& shape, const LeastSquaresSummary& solution,
                   int residuals) {
  fit.solution = solution;
  fit.law = shape.with_parameters(solution.parameters);
  fit.nuisance = solution.parameters.tail(solution.parameters.size() - shape.parameter_count());
  const auto free = ((fit.limits.upper - fit.limits.lower).array() > 0).count();
  fit.rms =
      std::sqrt(2 * solution.cost / std::max<double>(residuals - static_cast<double>(free), 1));
}

LawFit best_trial(const ComponentProblem& problem, const ComponentLaw& shape,
                  const FitOptions& options, const StopToken& stop,
                  const std::vector<ComponentLaw>& extra, const Effort& effort) {
  LawFit fit;
  fit.limits = limits_of(problem, shape, options);
  const LeastSquaresProblem least_squares = problem.least_squares(shape, fit.limits);
  const double exact = least_squares.residuals * kExactRms * kExactRms / 2;
  std::vector<double> costs;
  LeastSquaresSummary best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const ComponentLaw& law : starting_laws(problem, shape, extra)) {
    const LeastSquaresSummary solution =
        solve_least_squares(least_squares, start_vector(law, nuisance_start(problem)),
                            trial(std::max(best.cost, exact), effort), stop);
    costs.push_back(solution.cost);
    if (solution.cost < best.cost || best.parameters.size() == 0) best = solution;
  }
  take_solution(fit, shape, best, least_squares.residuals);
  fit.starts_tried = static_cast<int>(costs.size());
  for (const double cost : costs) {
    if (cost <= best.cost * (1 + kReachedShare) + exact) ++fit.starts_reached;
  }
  return fit;
}

}  // namespace

const std::string& component_of(const ComponentProblem& problem) {
  return problem.experiments().front()->info().component;
}

LawFit fit_law(const ComponentProblem& problem, const ComponentLaw& shape,
               const FitOptions& options, const StopToken& stop,
               const std::vector<ComponentLaw>& extra) {
  return refit(problem, best_trial(problem, shape, options, stop, extra, kTrial), stop);
}

LawFit fit_law_roughly(const ComponentProblem& problem, const ComponentLaw& shape,
                       const FitOptions& options, const StopToken& stop,
                       const std::vector<ComponentLaw>& extra) {
  return best_trial(problem, shape, options, stop, extra, kRough);
}

LawFit refit(const ComponentProblem& problem, const LawFit& fit, const StopToken& stop) {
  LawFit again = fit;
  const LeastSquaresProblem least_squares = problem.least_squares(fit.law, fit.limits);
  take_solution(again, fit.law,
                solve_least_squares(least_squares, fit.solution.parameters, finish(), stop),
                least_squares.residuals);
  return again;
}

LawFit reweighed(const ComponentProblem& problem, const LawFit& fit) {
  LawFit again = fit;
  const LeastSquaresProblem least_squares = problem.least_squares(fit.law, fit.limits);
  Eigen::VectorXd residual(least_squares.residuals);
  if (!least_squares.evaluate(fit.solution.parameters, residual, nullptr)) return again;
  LeastSquaresSummary solution = fit.solution;
  solution.cost = residual.squaredNorm() / 2;
  take_solution(again, fit.law, solution, least_squares.residuals);
  return again;
}

}  // namespace pliant
