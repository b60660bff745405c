#include "pliant/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/solver/free_change.h"

namespace pliant {
namespace {

Eigen::VectorXd diagonal_traces(const BlockMatrix& matrix) {
  Eigen::VectorXd traces(matrix.pattern().size());
  for (int i = 0; i < traces.size(); ++i) {
    traces(i) = matrix.diagonal(i).diagonal().cwiseAbs().sum() / 3;
  }
  return traces.cwiseMax(1e-12 * traces.maxCoeff());
}

bool factorize(const Objective& objective, const BlockMatrix& matrix, LinearSolver& solver) {
  const Timed counted = objective.timed(&SearchCosts::equations);
  return solver.factorize(matrix);
}

// Factorises a matrix, with a share of its diagonal added where it is not positive definite: a tiny
// share helps where a direction has no stiffness at all, such as a clip that turns about its own
// line of points.
bool factorize_shifted(const Objective& objective, BlockMatrix& matrix, LinearSolver& solver,
                       int& factorizations) {
  constexpr double kTiny = 1e-9, kFirst = 1e-4, kGrowth = 8, kLargest = 1e8;
  const Eigen::VectorXd traces = diagonal_traces(matrix);
  double added = 0;
  for (double shift = 0; shift < kLargest;
       shift = shift == 0 ? kTiny : std::max(kFirst, shift * kGrowth)) {
    for (int i = 0; i < traces.size(); ++i) {
      matrix.add_to_diagonal(i, (shift - added) * traces(i));
    }
    added = shift;
    ++factorizations;
    if (factorize(objective, matrix, solver)) return true;
  }
  return false;
}

// The largest force of a reduced gradient.
double largest_force(const Coordinates& coordinates, const Configuration& at,
                     const Eigen::VectorXd& reduced) {
  if (!reduced.allFinite()) return INFINITY;
  double largest = 0;
  for (int i = 0; i < coordinates.points(); ++i) {
    if (!coordinates.is_free(i)) continue;
    largest = std::max(largest, reduced.segment<3>(3 * coordinates.row(i)).cwiseAbs().maxCoeff());
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const auto forces = reduced.segment<6>(3 * coordinates.clip_row(k));
    const double radius = coordinates.clip_radius(k, at);
    largest = std::max(largest, forces.head<3>().cwiseAbs().maxCoeff());
    if (radius > 0) largest = std::max(largest, forces.tail<3>().cwiseAbs().maxCoeff() / radius);
  }
  return largest;
}

// Where a search stands.
struct Iterate {
  Configuration at;
  Eigen::Matrix3Xd gradient;  // dE / d points (N)
  Energy energy;
};

// Halves the step until the energy falls by a part of what its slope promises. Where the change is
// lost in rounding, the step must bring the forces down instead. Most steps are taken whole, so
// that the forces that the next one starts from come with the energy.
bool line_search(const Objective& objective, const Eigen::VectorXd& step, double slope,
                 double residual, Iterate& now) {
  constexpr double kShare = 1e-4, kShortest = 1e-10;
  const Coordinates& coordinates = objective.system().coordinates();
  const double rounding = 1e-13 * (std::abs(now.energy.stored) + std::abs(now.energy.work));
  Iterate trial;
  for (double length = 1; length > kShortest; length /= 2) {
    trial.at = coordinates.moved(now.at, length * step);
    if (!part_is_free(objective, now.at, trial.at)) continue;
    trial.energy = objective.evaluate(trial.at, trial.gradient);
    const double change = trial.energy.total() - now.energy.total();
    const bool falls = change <= kShare * length * slope;
    const bool lost = std::abs(length * slope) < rounding && change < rounding;
    if (falls || (lost && largest_force(coordinates, trial.at, trial.gradient) < residual)) {
      now = std::move(trial);
      return true;
    }
  }
  return false;
}

// Newton's step. Its accuracy matters little; that the matrix is positive definite does.
bool solve(const Objective& objective, const LinearSolver& solver, const Eigen::VectorXd& force,
           Eigen::VectorXd& step, NewtonSummary& summary) {
  const Timed counted = objective.timed(&SearchCosts::equations);
  step = Eigen::VectorXd::Zero(force.size());
  const LinearSummary linear = solver.solve(force, step);
  summary.linear_iterations += linear.iterations;
  return linear.converged;
}

// Newton's step with a new Hessian; nothing where no shift makes it positive definite.
std::optional<Eigen::VectorXd> fresh_step(const Objective& objective, const NewtonOptions& options,
                                          Workspace& workspace, const Configuration& at,
                                          const Eigen::VectorXd& force, NewtonSummary& summary) {
  auto& [hessian, solver] = workspace;
  Eigen::Matrix3Xd gradient;
  Eigen::VectorXd step;
  if (options.curvature == Curvature::exact) {
    objective.linearize(at, Curvature::exact, gradient, hessian);
    ++summary.factorizations;
    if (factorize(objective, hessian.matrix, *solver) &&
        solve(objective, *solver, force, step, summary)) {
      return step;
    }
  }
  objective.linearize(at, Curvature::convex, gradient, hessian);
  if (!factorize_shifted(objective, hessian.matrix, *solver, summary.factorizations)) {
    return std::nullopt;
  }
  solve(objective, *solver, force, step, summary);
  return step;
}

}  // namespace

double largest_force(const Coordinates& coordinates, const Configuration& at,
                     const Eigen::Matrix3Xd& gradient) {
  return largest_force(coordinates, at, coordinates.reduce(at, gradient));
}

NewtonSummary minimize(const Objective& objective, const NewtonOptions& options,
                       Workspace& workspace, Configuration& at) {
  constexpr double kFast = 0.8;  // fall of the forces with which an old factor is worth keeping
  const Coordinates& coordinates = objective.system().coordinates();
  NewtonSummary summary;
  bool has_factor = false;
  double last_residual = INFINITY;
  Iterate now{at, {}, {}};
  now.energy = objective.evaluate(now.at, now.gradient);
  for (;; ++summary.iterations) {
    options.stop.throw_if_requested();
    const Eigen::VectorXd force = -coordinates.reduce(now.at, now.gradient);
    at = now.at;
    summary.energy = now.energy;
    summary.residual = largest_force(coordinates, at, force);
    summary.converged = summary.residual < options.tolerance;
    if (summary.converged || summary.iterations == options.max_iterations ||
        !std::isfinite(summary.residual + now.energy.total())) {
      return summary;
    }
    Eigen::VectorXd step;
    const auto searched = [&](const Eigen::VectorXd& change) {
      const double slope = -force.dot(change);
      return slope < 0 && line_search(objective, change, slope, summary.residual, now);
    };
    const auto descend = [&] {
      const FreeChange free = free_change(objective, at, step);
      return (!free.whole && searched(free.each)) || searched(free.alike);
    };
    const bool reuse =
        options.reuse_factor && has_factor && summary.residual < kFast * last_residual;
    last_residual = summary.residual;
    if (reuse) {
      solve(objective, *workspace.solver, force, step, summary);
      if (descend()) continue;
    }
    std::optional<Eigen::VectorXd> fresh =
        fresh_step(objective, options, workspace, at, force, summary);
    if (!fresh) return summary;
    has_factor = true;
    step = std::move(*fresh);
    if (!descend()) return summary;
  }
}

}  // namespace pliant
