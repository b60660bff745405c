#include "pliant/solver/descent.h"

#include <cmath>
#include <optional>

#include "pliant/solver/free_change.h"

namespace pliant {
namespace {

double largest_motion(const Configuration& from, const Configuration& to) {
  return std::sqrt((to.positions - from.positions).colwise().squaredNorm().maxCoeff());
}

// Shortens a change until the energy falls by a part of what its slope promises.
// @param energy  at `at`; both change together
// @return whether it does
bool search_along(const Objective& objective, const Eigen::VectorXd& change, double slope,
                  double shortest, Energy& energy, Configuration& at) {
  constexpr double kShare = 1e-4;
  if (slope > 0) return false;
  const double rounding = 1e-13 * (std::abs(energy.stored) + std::abs(energy.work));
  for (double length = 1; length > shortest; length /= 2) {
    Configuration trial = objective.system().coordinates().moved(at, length * change);
    if (!part_is_free(objective, at, trial)) continue;
    const Energy there = objective.energy(trial);
    if (there.total() - energy.total() <= kShare * length * slope + rounding) {
      at = std::move(trial);
      energy = there;
      return true;
    }
  }
  return false;
}

// Takes a change whole, or as much of it as is free and brings less energy: first with each point
// for itself, as one that meets something says nothing of those far away.
// @return whether the energy fell
bool go_down(const Objective& objective, const Eigen::VectorXd& force, const FreeChange& free,
             Energy& energy, Configuration& at) {
  constexpr double kShortest = 1e-3, kShortestOfEach = 0.1;
  const auto searched = [&](const Eigen::VectorXd& change, double shortest) {
    return search_along(objective, change, -force.dot(change), shortest, energy, at);
  };
  if (!free.whole && searched(free.each, kShortestOfEach)) return true;
  return searched(free.alike, kShortest);
}

// Nothing where the matrix is not positive definite.
std::optional<LinearSummary> solved(const Objective& objective, Workspace& workspace,
                                    const Eigen::VectorXd& force, Eigen::VectorXd& change) {
  const Timed counted = objective.timed(&SearchCosts::equations);
  if (!workspace.solver->factorize(workspace.hessian.matrix)) return std::nullopt;
  return workspace.solver->solve(force, change);
}

}  // namespace

DescentSummary descend(const Objective& objective, const DescentOptions& options,
                       Eigen::VectorXd change, Workspace& workspace, Configuration& at) {
  const Coordinates& coordinates = objective.system().coordinates();
  DescentSummary summary;
  Eigen::Matrix3Xd gradient;
  bool settled = true;
  double motion = INFINITY;
  for (int left = options.iterations; left > 0 && (!settled || motion > options.motion);) {
    if (summary.iterations == options.most_iterations) break;
    Energy energy = objective.linearize(at, Curvature::convex, gradient, workspace.hessian);
    if (summary.iterations++ == 0) summary.start = energy;
    summary.end = energy;
    const Eigen::VectorXd force = -coordinates.reduce(at, gradient);
    const bool finite = force.allFinite() && std::isfinite(energy.total());
    const auto linear = finite ? solved(objective, workspace, force, change) : std::nullopt;
    summary.converged = linear.has_value();
    if (!linear) {
      summary.residual = INFINITY;
      break;
    }
    summary.linear_iterations += linear->iterations;
    summary.residual = linear->residual;
    const Configuration before = at;
    if (options.line_search) {
      const FreeChange free = free_change(objective, at, change);
      summary.converged = go_down(objective, force, free, energy, at) ||
                          largest_motion(at, coordinates.moved(at, change)) <= options.motion;
      summary.end = energy;
      settled = free.lost <= options.motion && energy.total() <= options.most_energy;
    } else {
      at = coordinates.moved(at, change);
      summary.converged = linear->converged;
    }
    if (!summary.converged) break;
    if (settled) --left;
    motion = largest_motion(before, at);
    change.setZero();
  }
  return summary;
}

}  // namespace pliant
