#include "pliant/solver/newton.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

Eigen::VectorXd diagonal_traces(const BlockMatrix& matrix) {
  Eigen::VectorXd traces(matrix.pattern().size());
  for (int i = 0; i < traces.size(); ++i) {
    traces(i) = matrix.block(matrix.pattern().diagonal(i)).diagonal().cwiseAbs().sum() / 3;
  }
  return traces.cwiseMax(1e-12 * traces.maxCoeff());
}

// Factorises a matrix, with a share of its diagonal added where it is not positive definite: a tiny
// share helps where a direction has no stiffness at all, such as a clip that turns about its own
// line of points.
bool factorize_shifted(BlockMatrix& matrix, LinearSolver& solver, int& factorizations) {
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
    if (solver.factorize(matrix)) return true;
  }
  return false;
}

// Halves the step until the energy falls by a part of what its slope promises. Where the change is
// lost in rounding, the step must bring the forces down instead.
bool line_search(const Objective& objective, const Eigen::VectorXd& step, double slope,
                 const Energy& energy, double residual, Configuration& at) {
  constexpr double kShare = 1e-4, kShortest = 1e-10;
  const Coordinates& coordinates = objective.system().coordinates();
  const double rounding = 1e-13 * (std::abs(energy.stored) + std::abs(energy.work));
  for (double length = 1; length > kShortest; length /= 2) {
    const Configuration trial = coordinates.moved(at, length * step);
    const double change = objective.energy(trial).total() - energy.total();
    const bool falls = change <= kShare * length * slope;
    const bool lost = std::abs(length * slope) < rounding && change < rounding;
    if (falls ||
        (lost && largest_force(coordinates, trial, objective.gradient(trial)) < residual)) {
      at = trial;
      return true;
    }
  }
  return false;
}

// Newton's step. Its accuracy matters little; that the matrix is positive definite does.
bool solve(const LinearSolver& solver, const Eigen::VectorXd& force, Eigen::VectorXd& step,
           NewtonSummary& summary) {
  step = Eigen::VectorXd::Zero(force.size());
  const LinearSummary linear = solver.solve(force, step);
  summary.linear_iterations += linear.iterations;
  return linear.converged;
}

}  // namespace

double largest_force(const Coordinates& coordinates, const Configuration& at,
                     const Eigen::Matrix3Xd& gradient) {
  double largest = 0;
  bool finite = true;
  for (int i = 0; i < coordinates.points(); ++i) {
    if (!coordinates.is_free(i)) continue;
    const double force = gradient.col(i).cwiseAbs().maxCoeff();
    finite = finite && std::isfinite(force);
    largest = std::max(largest, force);
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const Eigen::Vector3d origin = at.clips[static_cast<size_t>(k)].translation;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
    double radius = 0;
    for (const int point : coordinates.clip_points(k)) {
      const Eigen::Vector3d arm = at.positions.col(point) - origin, g = gradient.col(point);
      force += g;
      moment += arm.cross(g);
      radius = std::max(radius, arm.norm());
    }
    finite = finite && force.allFinite() && moment.allFinite();
    largest = std::max(largest, force.cwiseAbs().maxCoeff());
    if (radius > 0) largest = std::max(largest, moment.cwiseAbs().maxCoeff() / radius);
  }
  return finite ? largest : INFINITY;
}

NewtonSummary minimize(const Objective& objective, const NewtonOptions& options,
                       LinearSolver& solver, Hessian& hessian, Configuration& at) {
  const Coordinates& coordinates = objective.system().coordinates();
  NewtonSummary summary;
  Eigen::Matrix3Xd gradient;
  for (;; ++summary.iterations) {
    summary.energy = objective.linearize(at, options.curvature, gradient, hessian);
    summary.residual = largest_force(coordinates, at, gradient);
    summary.converged = summary.residual < options.tolerance;
    if (summary.converged || summary.iterations == options.max_iterations ||
        !std::isfinite(summary.residual)) {
      return summary;
    }
    const Eigen::VectorXd force = -coordinates.reduce(at, gradient);
    Eigen::VectorXd step;
    bool solved = false;
    if (options.curvature == Curvature::exact) {
      ++summary.factorizations;
      solved = solver.factorize(hessian.matrix) && solve(solver, force, step, summary);
      if (!solved) objective.linearize(at, Curvature::convex, gradient, hessian);
    }
    if (!solved) {
      if (!factorize_shifted(hessian.matrix, solver, summary.factorizations)) return summary;
      solve(solver, force, step, summary);
    }
    const double slope = -force.dot(step);
    if (!(slope < 0) ||
        !line_search(objective, step, slope, summary.energy, summary.residual, at)) {
      return summary;
    }
  }
}

}  // namespace pliant
