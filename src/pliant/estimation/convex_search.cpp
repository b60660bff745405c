#include "pliant/estimation/convex_search.h"

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/QR>

namespace pliant {
namespace {

constexpr int kCutRounds = 40;
constexpr int kHalvings = 10;
// Of linearised problems, in units of what residuals change by: enough for numbers that they do not
// tell to stay where they are.
constexpr double kDamping = 1e-6;

void append_rows(const Eigen::MatrixXd& more, Eigen::MatrixXd& rows) {
  const Eigen::Index before = rows.rows();
  rows.conservativeResize(before + more.rows(), more.cols());
  rows.bottomRows(more.rows()) = more;
}

// Least squares under conditions, which grow by those that solutions violate.
LeastSquaresSummary solve_with_cuts(const ConvexSet& set, LeastSquaresProblem problem,
                                    const Eigen::VectorXd& start,
                                    const LeastSquaresOptions& options, const StopToken& stop) {
  problem.not_negative = set.rows;
  LeastSquaresSummary end{.parameters = start};
  for (int round = 0; round < kCutRounds; ++round) {
    end = solve_least_squares(problem, end.parameters, options, stop);
    if (!set.violated) return end;
    const Eigen::MatrixXd cuts = set.violated(end.parameters);
    if (cuts.rows() == 0) return end;
    append_rows(cuts, problem.not_negative);
  }
  end.converged = false;
  return end;
}

// The same bounds and scales with a linear residual, matrix p + offset.
LeastSquaresProblem linear_problem(const LeastSquaresProblem& problem, Eigen::MatrixXd matrix,
                                   Eigen::VectorXd offset) {
  LeastSquaresProblem linear;
  linear.lower = problem.lower;
  linear.upper = problem.upper;
  linear.scale = problem.scale;
  linear.residuals = static_cast<int>(offset.size());
  linear.evaluate = [matrix = std::move(matrix), offset = std::move(offset)](
                        const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                        Eigen::MatrixXd* jacobian) {
    residual = matrix * p + offset;
    if (jacobian) *jacobian = matrix;
    return true;
  };
  return linear;
}

// Where a search stands: a point of the set and its cost.
struct Stand {
  Eigen::VectorXd at;
  double cost = 0;
};

// Halves the way to another point of the set, which lies in it, until that costs less.
// @return how much less, 0 where nothing does; `stand` moves there
double go_towards(const LeastSquaresProblem& problem, Eigen::VectorXd next, Stand& stand) {
  for (int half = 0; half <= kHalvings; ++half) {
    const double cost = cost_at(problem, next);
    if (cost < stand.cost) {
      const double gain = stand.cost - cost;
      stand = {std::move(next), cost};
      return gain;
    }
    next = (next + stand.at) / 2;
  }
  return 0;
}

// The least of the problem linearised at a point, within the set.
std::optional<Eigen::VectorXd> linear_best(const ConvexSet& set, const LeastSquaresProblem& problem,
                                           const Eigen::VectorXd& at, const StopToken& stop) {
  Eigen::VectorXd residual(problem.residuals);
  Eigen::MatrixXd jacobian;
  if (!problem.evaluate(at, residual, &jacobian)) return std::nullopt;
  const Eigen::Index count = at.size();
  const Eigen::VectorXd sizes =
      (jacobian * problem.scale.asDiagonal()).colwise().norm().cwiseMax(1e-12);
  Eigen::MatrixXd rows(jacobian.rows() + count, count);
  rows << jacobian, Eigen::MatrixXd((kDamping * sizes.cwiseQuotient(problem.scale)).asDiagonal());
  Eigen::VectorXd target(rows.rows());  // rows (p - at) + target
  target << residual, Eigen::VectorXd::Zero(count);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::VectorXd turned = (qr.householderQ().transpose() * target).head(count);
  return solve_with_cuts(set, linear_problem(problem, triangle, turned - triangle * at), at, {},
                         stop)
      .parameters;
}

// An update of the unknowns without conditions.
Eigen::VectorXd updated(const LeastSquaresProblem& problem, const Stand& from,
                        LeastSquaresOptions options, const StopToken& stop) {
  LeastSquaresSummary end;
  for (const int iterations : {1, 10}) {  // not every iteration is a step
    options.max_iterations = iterations;
    end = solve_least_squares(problem, from.at, options, stop);
    if (end.cost < from.cost) break;
  }
  return end.parameters;
}

// From a point of the set to better ones, each in the direction of another point of it.
// @param next_of  that point, from a stand; none: there is no prediction at the stand
template <class NextOf>
LeastSquaresSummary search_by(const ConvexSet& set, const LeastSquaresProblem& problem,
                              const Eigen::VectorXd& start, const LeastSquaresOptions& options,
                              const StopToken& stop, const NextOf& next_of) {
  Stand stand{nearest_within(set, problem, start, stop), 0};
  stand.cost = cost_at(problem, stand.at);
  LeastSquaresSummary end;
  while (std::isfinite(stand.cost) && !end.converged && end.iterations < options.max_iterations) {
    const std::optional<Eigen::VectorXd> next = next_of(stand);
    if (!next) break;
    const double gain = go_towards(problem, *next, stand);
    ++end.iterations;
    end.converged = gain <= options.function_tolerance * stand.cost;
  }
  end.parameters = stand.at;
  end.cost = stand.cost;
  return end;
}

}  // namespace

LeastSquaresSummary solve_within(const ConvexSet& set, LeastSquaresProblem problem,
                                 const Eigen::VectorXd& start, const LeastSquaresOptions& options,
                                 const StopToken& stop) {
  if (!set.violated) {
    problem.not_negative = set.rows;
    return solve_least_squares(problem, start, options, stop);
  }
  return search_by(set, problem, start, options, stop,
                   [&](const Stand& stand) { return linear_best(set, problem, stand.at, stop); });
}

Eigen::VectorXd nearest_within(const ConvexSet& set, const LeastSquaresProblem& problem,
                               const Eigen::VectorXd& point, const StopToken& stop) {
  const Eigen::VectorXd per_scale = problem.scale.cwiseInverse();
  const LeastSquaresProblem distance = linear_problem(
      problem, Eigen::MatrixXd(per_scale.asDiagonal()), -per_scale.cwiseProduct(point));
  return solve_with_cuts(set, distance, point, {}, stop).parameters;
}

LeastSquaresSummary solve_projected(const ConvexSet& set, const LeastSquaresProblem& problem,
                                    const Eigen::VectorXd& start,
                                    const LeastSquaresOptions& options, const StopToken& stop) {
  return search_by(set, problem, start, options, stop,
                   [&](const Stand& stand) -> std::optional<Eigen::VectorXd> {
                     return nearest_within(set, problem, updated(problem, stand, options, stop),
                                           stop);
                   });
}

}  // namespace pliant
