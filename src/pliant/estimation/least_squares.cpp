#include "pliant/estimation/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <ceres/ceres.h>

namespace pliant {
namespace {

constexpr double kTouchShare = 1e-9;  // of the scale: nearer than this is at the bound
constexpr int kBoundRounds = 10;
// Beside a bound so many steps, one after the other, that gain less than that share of what they
// promise stall.
constexpr int kStalledSteps = 2;
constexpr double kKept = 0.5;
constexpr double kMargin = 1e-7;  // of inequalities, in units of what the parameters change by
constexpr int kMultiplierRounds = 30;

// The free parameters in units of their scale.
class ScaledParameters {
 public:
  ScaledParameters(const LeastSquaresProblem& problem, const Eigen::VectorXd& start)
      : problem_(problem), all_(start.cwiseMax(problem.lower).cwiseMin(problem.upper)) {
    for (Eigen::Index i = 0; i < all_.size(); ++i) {
      if (problem.lower(i) < problem.upper(i)) free_.push_back(i);
    }
  }

  int size() const { return static_cast<int>(free_.size()); }
  Eigen::Index index(int i) const { return free_[static_cast<size_t>(i)]; }
  double scale(int i) const { return problem_.scale(index(i)); }

  std::vector<double> scaled() const {
    std::vector<double> values;
    for (int i = 0; i < size(); ++i) values.push_back(all_(index(i)) / scale(i));
    return values;
  }

  Eigen::VectorXd unscaled(const double* values) const {
    Eigen::VectorXd all = all_;
    for (int i = 0; i < size(); ++i) {
      // Scaling must not carry a parameter over its bound by a rounding error.
      all(index(i)) =
          std::clamp(values[i] * scale(i), problem_.lower(index(i)), problem_.upper(index(i)));
    }
    return all;
  }

 private:
  const LeastSquaresProblem& problem_;
  Eigen::VectorXd all_;
  std::vector<Eigen::Index> free_;
};

// Of a step that is tried Ceres asks for the residual first and, where it is taken, for the
// Jacobian then; a search begins where the one before it has ended: one evaluation answers all.
class LastEvaluation {
 public:
  explicit LastEvaluation(const LeastSquaresProblem& problem)
      : problem_(problem), residual_(problem.residuals) {}

  // Whether there is a residual at these parameters.
  bool at(const Eigen::VectorXd& parameters) {
    if (last_.size() != parameters.size() || last_ != parameters) {
      last_ = parameters;
      found_ = problem_.evaluate(parameters, residual_, &jacobian_) && residual_.allFinite();
    }
    return found_;
  }

  const Eigen::VectorXd& residual() const { return residual_; }
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }

 private:
  const LeastSquaresProblem& problem_;
  Eigen::VectorXd last_, residual_;
  Eigen::MatrixXd jacobian_;
  bool found_ = false;
};

// 1 for each free parameter at a bound against which the cost pushes it.
std::vector<char> pressed_to_bounds(const LeastSquaresProblem& problem, const Eigen::VectorXd& p,
                                    LastEvaluation& last) {
  std::vector<char> pressed(static_cast<size_t>(p.size()), 0);
  if (!last.at(p)) return pressed;
  const Eigen::VectorXd gradient = last.jacobian().transpose() * last.residual();
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    if (problem.lower(i) == problem.upper(i)) continue;
    const double touch = kTouchShare * problem.scale(i);
    const bool below = p(i) - problem.lower(i) <= touch && gradient(i) > 0;
    const bool above = problem.upper(i) - p(i) <= touch && gradient(i) < 0;
    pressed[static_cast<size_t>(i)] = below || above;
  }
  return pressed;
}

class Residuals : public ceres::CostFunction {
 public:
  /// @param at_bound  is told whether the last step that was taken ends pressed to a bound
  Residuals(const LeastSquaresProblem& problem, const ScaledParameters& parameters,
            LastEvaluation& last, bool& at_bound)
      : problem_(problem), parameters_(parameters), last_(last), at_bound_(at_bound) {
    set_num_residuals(problem.residuals);
    mutable_parameter_block_sizes()->push_back(parameters.size());
  }

  bool Evaluate(double const* const* values, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd all = parameters_.unscaled(values[0]);
    if (!last_.at(all)) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, problem_.residuals) = last_.residual();
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    if (!last_.jacobian().allFinite()) return false;
    at_bound_ = std::ranges::count(pressed_to_bounds(problem_, all, last_), 1) > 0;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> scaled(jacobians[0], problem_.residuals, parameters_.size());
    for (int i = 0; i < parameters_.size(); ++i) {
      scaled.col(i) = last_.jacobian().col(parameters_.index(i)) * parameters_.scale(i);
    }
    return true;
  }

 private:
  const LeastSquaresProblem& problem_;
  const ScaledParameters& parameters_;
  LastEvaluation& last_;
  bool& at_bound_;
};

class StopCallback : public ceres::IterationCallback {
 public:
  /// @param at_bound  whether the last step that was taken ends pressed to a bound
  StopCallback(const StopToken& stop, const LeastSquaresOptions& options, const bool& at_bound)
      : stop_(stop), options_(options), at_bound_(at_bound) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& iteration) override {
    if (stop_.stop_requested()) return ceres::SOLVER_ABORT;
    const bool hopeless =
        iteration.iteration >= options_.patience && iteration.cost > options_.hopeless_cost;
    settled_ = promises_nothing(iteration);
    const bool keeps_promise = iteration.iteration == 0 || (iteration.step_is_successful &&
                                                            iteration.relative_decrease > kKept);
    poor_steps_ = keeps_promise ? 0 : poor_steps_ + 1;
    const bool stalled = at_bound_ && poor_steps_ >= kStalledSteps;
    return hopeless || settled_ || stalled ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                           : ceres::SOLVER_CONTINUE;
  }

  bool settled() const { return settled_; }

 private:
  // Whether the last step would have gained nothing if residuals were linear. What it did gain,
  // which Ceres looks at, never falls below the rounding of predictions that are iterated.
  bool promises_nothing(const ceres::IterationSummary& iteration) const {
    const double gained = iteration.cost_change, share = iteration.relative_decrease;
    if (iteration.iteration == 0 || share == 0 || !std::isfinite(share)) return false;
    const double promised = gained / share;
    const double lower = std::min(iteration.cost, iteration.cost + gained);  // of before and after
    return promised >= 0 && promised <= options_.function_tolerance * lower;
  }

  const StopToken& stop_;
  const LeastSquaresOptions& options_;
  const bool& at_bound_;
  bool settled_ = false;
  int poor_steps_ = 0;  // in a row
};

ceres::Solver::Options solver_options(const LeastSquaresOptions& options) {
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.function_tolerance;
  solver.gradient_tolerance = options.gradient_tolerance;
  solver.parameter_tolerance = options.parameter_tolerance;
  solver.max_num_line_search_step_size_iterations = 0;  // the trust region alone shortens steps
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;  // the same bits whatever else runs
  return solver;
}

LeastSquaresSummary solve_in_bounds(const LeastSquaresProblem& problem,
                                    const Eigen::VectorXd& start,
                                    const LeastSquaresOptions& options, const StopToken& stop,
                                    LastEvaluation& last) {
  stop.throw_if_requested();
  const ScaledParameters parameters(problem, start);
  std::vector<double> values = parameters.scaled();
  LeastSquaresSummary summary;
  summary.parameters = parameters.unscaled(values.data());

  if (!last.at(summary.parameters)) {
    summary.cost = std::numeric_limits<double>::infinity();
    return summary;
  }
  summary.cost = last.residual().squaredNorm() / 2;
  if (parameters.size() == 0) {
    summary.converged = true;
    return summary;
  }

  ceres::Problem ceres_problem;
  bool at_bound = false;
  ceres_problem.AddResidualBlock(new Residuals(problem, parameters, last, at_bound), nullptr,
                                 values.data());
  for (int i = 0; i < parameters.size(); ++i) {
    ceres_problem.SetParameterLowerBound(values.data(), i,
                                         problem.lower(parameters.index(i)) / parameters.scale(i));
    ceres_problem.SetParameterUpperBound(values.data(), i,
                                         problem.upper(parameters.index(i)) / parameters.scale(i));
  }
  ceres::Solver::Options solver = solver_options(options);
  StopCallback callback(stop, options, at_bound);
  solver.callbacks.push_back(&callback);
  ceres::Solver::Summary report;
  ceres::Solve(solver, &ceres_problem, &report);
  stop.throw_if_requested();

  summary.parameters = parameters.unscaled(values.data());
  summary.cost = report.final_cost;
  summary.converged = report.termination_type == ceres::CONVERGENCE || callback.settled();
  summary.iterations = static_cast<int>(report.iterations.size());
  return summary;
}

LeastSquaresProblem with_held(LeastSquaresProblem problem, const Eigen::VectorXd& p,
                              const std::vector<char>& held) {
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    if (!held[static_cast<size_t>(i)]) continue;
    const bool at_lower = p(i) - problem.lower(i) < problem.upper(i) - p(i);
    (at_lower ? problem.upper : problem.lower)(i) = (at_lower ? problem.lower : problem.upper)(i);
  }
  return problem;
}

LeastSquaresSummary solve_without_inequalities(const LeastSquaresProblem& problem,
                                               const Eigen::VectorXd& start,
                                               const LeastSquaresOptions& options,
                                               const StopToken& stop) {
  LastEvaluation last(problem);
  LeastSquaresSummary summary = solve_in_bounds(problem, start, options, stop, last);
  if (!std::isfinite(summary.cost)) return summary;
  // Ceres clips its steps to the bounds and stalls beside one: what is pressed to a bound is held
  // there and the rest solved again, until a solution presses what was held for it.
  std::vector<char> held(static_cast<size_t>(start.size()), 0);
  for (int round = 0; round < kBoundRounds && summary.cost <= options.hopeless_cost; ++round) {
    const std::vector<char> pressed = pressed_to_bounds(problem, summary.parameters, last);
    if (pressed == held) break;
    held = pressed;
    const int iterations = summary.iterations;
    summary = solve_in_bounds(with_held(problem, summary.parameters, held), summary.parameters,
                              options, stop, last);
    summary.iterations += iterations;
  }
  return summary;
}

// The rows of `not_negative` in units of what the parameters change by.
Eigen::MatrixXd scaled_inequalities(const LeastSquaresProblem& problem) {
  const Eigen::VectorXd size = problem.not_negative.cwiseAbs() * problem.scale;
  return size.cwiseMax(1e-300).cwiseInverse().asDiagonal() * problem.not_negative;
}

// The problem with what its inequalities lack of `least` as further residuals.
LeastSquaresProblem with_penalty(const LeastSquaresProblem& problem,
                                 const Eigen::MatrixXd& inequalities, const Eigen::VectorXd& least,
                                 double weight) {
  LeastSquaresProblem penalised = problem;
  penalised.residuals += static_cast<int>(inequalities.rows());
  penalised.evaluate = [&problem, &inequalities, least, weight](const Eigen::VectorXd& p,
                                                                Eigen::VectorXd& residual,
                                                                Eigen::MatrixXd* jacobian) {
    Eigen::VectorXd own(problem.residuals);
    if (!problem.evaluate(p, own, jacobian)) return false;
    const Eigen::VectorXd lacking = (inequalities * p - least).cwiseMin(0);
    residual.resize(own.size() + lacking.size());
    residual << own, std::sqrt(weight) * lacking;
    if (jacobian == nullptr) return true;
    jacobian->conservativeResize(residual.size(), Eigen::NoChange);
    for (Eigen::Index i = 0; i < lacking.size(); ++i) {
      jacobian->row(own.size() + i) =
          (lacking(i) < 0 ? std::sqrt(weight) : 0) * inequalities.row(i);
    }
    return true;
  };
  return penalised;
}

double largest_curvature(const LeastSquaresProblem& problem, const Eigen::VectorXd& p) {
  Eigen::VectorXd residual(problem.residuals);
  Eigen::MatrixXd jacobian;
  if (!problem.evaluate(p, residual, &jacobian)) return 1;
  return (jacobian * problem.scale.asDiagonal()).colwise().squaredNorm().maxCoeff();
}

}  // namespace

double cost_at(const LeastSquaresProblem& problem, const Eigen::VectorXd& values) {
  Eigen::VectorXd residual(problem.residuals);
  const bool found = problem.evaluate(values, residual, nullptr);
  return found ? residual.squaredNorm() / 2 : std::numeric_limits<double>::infinity();
}

LeastSquaresSummary solve_least_squares(const LeastSquaresProblem& problem,
                                        const Eigen::VectorXd& start,
                                        const LeastSquaresOptions& options, const StopToken& stop) {
  LeastSquaresSummary summary = solve_without_inequalities(problem, start, options, stop);
  if (problem.not_negative.rows() == 0 || !std::isfinite(summary.cost)) return summary;
  const Eigen::MatrixXd inequalities = scaled_inequalities(problem);
  // Multipliers in units of the weight, which grows. An inequality with one is an equality.
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(inequalities.rows());
  const auto holds = [&] {
    const Eigen::VectorXd values = inequalities * summary.parameters;
    return values.minCoeff() >= 0 && values.cwiseMin(multipliers).maxCoeff() < 10 * kMargin;
  };
  double weight = std::max(largest_curvature(problem, summary.parameters), 1e-12);
  for (int round = 0; round < kMultiplierRounds && !holds(); ++round) {
    const Eigen::VectorXd least = multipliers.array() + kMargin;
    const int iterations = summary.iterations;
    summary = solve_without_inequalities(with_penalty(problem, inequalities, least, weight),
                                         summary.parameters, options, stop);
    if (!std::isfinite(summary.cost)) return summary;
    summary.iterations += iterations;
    multipliers = (least - inequalities * summary.parameters).cwiseMax(0) / 2;
    weight *= 2;
  }
  summary.converged = summary.converged && holds();
  summary.cost = cost_at(problem, summary.parameters);
  return summary;
}

}  // namespace pliant
