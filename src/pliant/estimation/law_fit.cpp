#include "pliant/estimation/law_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pliant/estimation/fit_journal.h"
#include "pliant/estimation/linear_start.h"
#include "pliant/estimation/monotone_stress.h"

namespace pliant {
namespace {

constexpr int kMostLinearStarts = 3;
constexpr std::size_t kMostPredicting = 4;
constexpr int kAgreeing = 2;        // of them
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

// Those of a linear fit, and spread around it.
std::vector<LawStart> linear_law_starts(const ComponentProblem& problem,
                                        const ComponentLaw& shape) {
  std::vector<LawStart> starts;
  for (const LinearStart& start : linear_starts(problem, shape, kMostLinearStarts)) {
    starts.push_back({start.law});
  }
  if (shape.friction_law == FrictionLaw::dahl) {
    const ComponentLaw first = starts.front().law;
    for (const double factor : {0.3, 3.0}) {
      starts.push_back({linear_start(problem, first, factor * first.friction[2]).law});
    }
  }
  return starts;
}

Eigen::VectorXd start_vector(const LawStart& start, const LawFit& fit) {
  Eigen::VectorXd all = starts_of(fit.unknowns);
  all.head(start.law.parameter_count()) = start.law.parameters();
  if (start.nuisance.size() > 0) all.tail(start.nuisance.size()) = start.nuisance;
  return all;
}

// Of what counts, and of priors.
int residual_count(const Problem& problem) {
  return problem.rows() + static_cast<int>(problem.priors().size());
}

// Per degree of freedom.
double rms_of(double cost, const LawFit& fit, int residuals) {
  return std::sqrt(2 * cost / std::max(residuals - free_count(fit.unknowns), 1));
}

void take_solution(LawFit& fit, const ComponentLaw& shape, const LeastSquaresSummary& solution,
                   int residuals) {
  fit.solution = solution;
  fit.law = shape.with_parameters(solution.parameters);
  fit.nuisance = solution.parameters.tail(solution.parameters.size() - shape.parameter_count());
  fit.rms = rms_of(solution.cost, fit, residuals);
}

/// @param enough  starts that lead to the best before the rest are left out
LawFit best_trial(const ComponentProblem& problem, const std::vector<LawStart>& starts,
                  const FitOptions& options, const Effort& effort,
                  int enough = std::numeric_limits<int>::max()) {
  const ComponentLaw& shape = starts.front().law;
  LawFit fit;
  fit.law = shape;
  fit.unknowns = problem.unknowns(shape, options);
  fit.monotone_stress = options.monotone_stress;
  const Problem rows = problem_of(problem, fit);
  const LeastSquaresProblem least_squares = rows.least_squares();
  const double exact = residual_count(rows) * kExactRms * kExactRms / 2;
  std::vector<LeastSquaresSummary> ends;
  const auto follow = [&](std::size_t start, double least) {
    const std::string question = fmt::format("start {} of {}", start + 1, component_of(problem));
    ends.push_back(answered(problem.journal(), question, [&] {
      return solve_least_squares(least_squares, start_vector(starts[start], fit),
                                 trial(std::max(least, exact), effort), problem.stop());
    }));
    return ends.back().cost;
  };
  const StartSearch search = search_from(starts.size(), follow, {.exact = exact, .enough = enough});
  take_solution(fit, shape, ends[search.best], residual_count(rows));
  fit.starts = {component_of(problem), "law", unit_of_residuals(problem), {}, search.reached_best};
  for (const double cost : search.costs) {
    fit.starts.ends.push_back(rms_of(cost, fit, residual_count(rows)));
  }
  return fit;
}

/// Linear fits over tau, those that predict best by the true problem first.
std::vector<LawStart> predicting_starts(const ComponentProblem& problem, const ComponentLaw& shape,
                                        const FitOptions& options) {
  LawFit fit;
  fit.law = shape;
  fit.unknowns = problem.unknowns(shape, options);
  const Problem rows = problem_of(problem, fit);
  const LeastSquaresProblem least_squares = rows.least_squares();
  std::vector<std::pair<double, LawStart>> all;
  for (const LinearStart& linear : linear_starts_over_tau(problem, shape)) {
    const LawStart start{linear.law};
    all.emplace_back(cost_at(least_squares, start_vector(start, fit)), start);
  }
  const auto cost = [](const auto& start) { return start.first; };
  std::ranges::stable_sort(all, {}, cost);
  if (all.size() > kMostPredicting) all.resize(kMostPredicting);
  std::vector<LawStart> starts;
  for (auto& [own, start] : all) starts.push_back(std::move(start));
  return starts;
}

/// The law that the easy parts of some experiments alone lead to; nothing where none has one, or
/// without friction, where no start goes wrong.
std::optional<LawStart> easy_start(const ComponentProblem& problem, const ComponentLaw& shape,
                                   const FitOptions& options) {
  if (shape.friction_law == FrictionLaw::none) return std::nullopt;
  const std::optional<ComponentProblem> easy = problem.easy_part();
  if (!easy) return std::nullopt;
  const LawFit fit =
      best_trial(*easy, predicting_starts(*easy, shape, options), options, kTrial, kAgreeing);
  return LawStart{fit.law, fit.nuisance};
}

std::vector<LawStart> first_starts(const ComponentProblem& problem, const ComponentLaw& shape,
                                   const FitOptions& options, const std::vector<LawStart>& extra) {
  std::vector<LawStart> starts;
  if (auto start = easy_start(problem, shape, options)) starts.push_back(std::move(*start));
  std::ranges::move(linear_law_starts(problem, shape), std::back_inserter(starts));
  starts.insert(starts.end(), extra.begin(), extra.end());
  return starts;
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

std::string unit_of_residuals(const ComponentProblem& problem) {
  const bool stated = std::ranges::any_of(problem.experiments(), [](const auto* experiment) {
    return experiment->info().force_noise || experiment->info().length_noise;
  });
  return stated ? "times the noise" : "% of range";
}

LawFit fit_law(const ComponentProblem& problem, const ComponentLaw& shape,
               const FitOptions& options, const std::vector<LawStart>& extra) {
  return fit_law_from(problem, first_starts(problem, shape, options, extra), options);
}

LawFit fit_law_from(const ComponentProblem& problem, const std::vector<LawStart>& starts,
                    const FitOptions& options) {
  return refit(problem, best_trial(problem, starts, options, kTrial));
}

LawFit fit_law_roughly(const ComponentProblem& problem, const ComponentLaw& shape,
                       const FitOptions& options, const std::vector<LawStart>& extra) {
  return best_trial(problem, first_starts(problem, shape, options, extra), options, kRough);
}

LawFit refit(const ComponentProblem& problem, const LawFit& fit) {
  LawFit again = fit;
  const Problem rows = problem_of(problem, fit);
  const LeastSquaresSummary solution =
      answered(problem.journal(), "search of " + component_of(problem), [&] {
        return solve_least_squares(rows.least_squares(), fit.solution.parameters, finish(),
                                   problem.stop());
      });
  take_solution(again, fit.law, solution, residual_count(rows));
  return again;
}

LawFit reweighed(const ComponentProblem& problem, const LawFit& fit) {
  LawFit again = fit;
  const Problem rows = problem_of(problem, fit);
  LeastSquaresSummary solution = fit.solution;
  solution.cost = cost_at(rows.least_squares(), solution.parameters);
  if (!std::isfinite(solution.cost)) return again;
  take_solution(again, fit.law, solution, residual_count(rows));
  return again;
}

}  // namespace pliant
