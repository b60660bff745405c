#include "pliant/solver/descent.h"

#include <cmath>

namespace pliant {
namespace {

double largest_motion(const Configuration& from, const Configuration& to) {
  return std::sqrt((to.positions - from.positions).colwise().squaredNorm().maxCoeff());
}

// Shortens a change until the energy falls by a part of what its slope promises.
// @return whether it does
bool search_along(const Objective& objective, const Eigen::VectorXd& change, double slope,
                  const Energy& energy, Configuration& at) {
  constexpr double kShare = 1e-4, kShortest = 1e-3;
  const double rounding = 1e-13 * (std::abs(energy.stored) + std::abs(energy.work));
  for (double length = 1; length > kShortest; length /= 2) {
    Configuration trial = objective.system().coordinates().moved(at, length * change);
    if (!objective.admits(trial)) continue;
    const double rise = objective.energy(trial).total() - energy.total();
    if (rise <= kShare * length * slope + rounding) {
      at = std::move(trial);
      return true;
    }
  }
  return false;
}

}  // namespace

DescentSummary descend(const Objective& objective, const DescentOptions& options,
                       Eigen::VectorXd change, Workspace& workspace, Configuration& at) {
  auto& [hessian, solver] = workspace;
  const Coordinates& coordinates = objective.system().coordinates();
  DescentSummary summary;
  Eigen::Matrix3Xd gradient;
  for (double motion = INFINITY; motion > options.motion; change.setZero()) {
    if (summary.iterations == options.iterations) break;
    const Energy energy = objective.linearize(at, Curvature::convex, gradient, hessian);
    if (summary.iterations++ == 0) summary.start = energy;
    const Eigen::VectorXd force = -coordinates.reduce(at, gradient);
    summary.converged = force.allFinite() && solver->factorize(hessian.matrix);
    if (!summary.converged) {
      summary.residual = INFINITY;
      break;
    }
    const LinearSummary linear = solver->solve(force, change);
    summary.linear_iterations += linear.iterations;
    summary.residual = linear.residual;
    const Configuration before = at;
    if (options.line_search) {
      const double slope = -force.dot(change);
      summary.converged = slope <= 0 && search_along(objective, change, slope, energy, at);
    } else {
      at = coordinates.moved(at, change);
      summary.converged = linear.converged;
    }
    if (!summary.converged) break;
    motion = largest_motion(before, at);
  }
  return summary;
}

}  // namespace pliant
