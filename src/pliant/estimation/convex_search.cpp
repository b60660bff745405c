#include "pliant/estimation/convex_search.h"

#include <cmath>

namespace pliant {
namespace {

constexpr int kCutRounds = 40;
constexpr int kHalvings = 8;

void append_rows(const Eigen::MatrixXd& more, Eigen::MatrixXd& rows) {
  const Eigen::Index before = rows.rows();
  rows.conservativeResize(before + more.rows(), more.cols());
  rows.bottomRows(more.rows()) = more;
}

// One accepted step of a search without conditions.
LeastSquaresSummary updated(const LeastSquaresProblem& problem, const Eigen::VectorXd& from,
                            double cost, LeastSquaresOptions options, const StopToken& stop) {
  LeastSquaresSummary end;
  for (const int iterations : {1, 10}) {
    options.max_iterations = iterations;
    end = solve_least_squares(problem, from, options, stop);
    if (end.cost < cost) break;
  }
  return end;
}

}  // namespace

LeastSquaresSummary solve_within(const ConvexSet& set, LeastSquaresProblem problem,
                                 const Eigen::VectorXd& start, const LeastSquaresOptions& options,
                                 const StopToken& stop) {
  problem.not_negative = set.rows;
  LeastSquaresSummary end{.parameters = start};
  int iterations = 0;
  for (int round = 0; round < kCutRounds; ++round) {
    end = solve_least_squares(problem, end.parameters, options, stop);
    end.iterations = iterations += end.iterations;
    if (!std::isfinite(end.cost) || !set.violated) return end;
    const Eigen::MatrixXd cuts = set.violated(end.parameters);
    if (cuts.rows() == 0) return end;
    append_rows(cuts, problem.not_negative);
  }
  end.converged = false;
  return end;
}

Eigen::VectorXd nearest_within(const ConvexSet& set, const LeastSquaresProblem& problem,
                               const Eigen::VectorXd& point, const StopToken& stop) {
  LeastSquaresProblem distance;
  distance.lower = problem.lower;
  distance.upper = problem.upper;
  distance.scale = problem.scale;
  distance.residuals = static_cast<int>(point.size());
  const Eigen::VectorXd per_scale = problem.scale.cwiseInverse();
  distance.evaluate = [&](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                          Eigen::MatrixXd* jacobian) {
    residual = per_scale.cwiseProduct(p - point);
    if (jacobian) *jacobian = per_scale.asDiagonal();
    return true;
  };
  return solve_within(set, distance, point, {}, stop).parameters;
}

LeastSquaresSummary solve_projected(const ConvexSet& set, const LeastSquaresProblem& problem,
                                    const Eigen::VectorXd& start,
                                    const LeastSquaresOptions& options, const StopToken& stop) {
  LeastSquaresSummary best;
  best.parameters = nearest_within(set, problem, start, stop);
  best.cost = cost_at(problem, best.parameters);
  while (std::isfinite(best.cost) && best.iterations < options.max_iterations) {
    const LeastSquaresSummary free = updated(problem, best.parameters, best.cost, options, stop);
    best.iterations += free.iterations;
    Eigen::VectorXd next = nearest_within(set, problem, free.parameters, stop);
    double cost = cost_at(problem, next);
    // The way between two points of the set lies in it.
    for (int half = 0; half < kHalvings && !(cost < best.cost); ++half) {
      next = (next + best.parameters) / 2;
      cost = cost_at(problem, next);
    }
    const double gain = best.cost - cost;
    if (gain > 0) {
      best.parameters = next;
      best.cost = cost;
    }
    if (!(gain > options.function_tolerance * best.cost)) {
      best.converged = true;
      break;
    }
  }
  return best;
}

}  // namespace pliant
