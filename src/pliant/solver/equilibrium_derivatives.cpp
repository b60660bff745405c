#include "pliant/solver/equilibrium_derivatives.h"

#include <cmath>

namespace pliant {
namespace {

Eigen::Map<const Eigen::Matrix3Xd> by_points(const Eigen::MatrixXd& all, Eigen::Index column) {
  return {all.col(column).data(), 3, all.rows() / 3};
}

}  // namespace

// Central differences along each motion: the Hessian has no rows for points that are moved from
// outside. The motion is scaled to a small part of the distance between neighbours, so that strains
// change by about 1e-6, far less than friction takes to turn around; at a limit of energy, of which
// as much is left, by far less.
Eigen::MatrixXd forces_along(const Objective& objective, const Configuration& at,
                             const Eigen::MatrixXd& motions) {
  const Eigen::Vector3d extent =
      at.positions.rowwise().maxCoeff() - at.positions.rowwise().minCoeff();
  const double distance =
      extent.norm() / std::sqrt(static_cast<double>(objective.system().points()));
  const double small = objective.system().is_limited() ? 1e-9 : 1e-6;
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(motions.rows(), motions.cols());
  for (Eigen::Index k = 0; k < motions.cols(); ++k) {
    const double largest = motions.col(k).cwiseAbs().maxCoeff();
    if (largest == 0) continue;
    const double length = small * distance / largest;
    Configuration forward = at, backward = at;
    forward.positions += length * by_points(motions, k);
    backward.positions -= length * by_points(motions, k);
    changes.col(k) =
        ((objective.gradient(forward) - objective.gradient(backward)) / (2 * length)).reshaped();
  }
  return changes;
}

std::optional<Curvature> factorize_at(const Objective& objective, const Configuration& at,
                                      Eigen::Matrix3Xd& gradient, Workspace& workspace) {
  for (const Curvature curvature : {Curvature::exact, Curvature::convex}) {
    objective.linearize(at, curvature, gradient, workspace.hessian);
    if (workspace.solver->factorize(workspace.hessian.matrix)) return curvature;
  }
  return std::nullopt;
}

EquilibriumDerivatives differentiate_equilibrium(const Objective& objective,
                                                 const Configuration& at,
                                                 const std::vector<int>& by,
                                                 const Eigen::MatrixXd& history_by_parameter,
                                                 const LinearSolver& solver, bool with_forces) {
  const System& system = objective.system();
  const Coordinates& coordinates = system.coordinates();
  const Eigen::Index rows = 3 * system.points(), columns = std::ssize(by);
  EquilibriumDerivatives result;
  result.forces.setZero(rows, columns);
  result.positions.resize(rows, columns);
  system.add_force_sensitivity(at, objective.conditions(), by, history_by_parameter, result.forces);
  Eigen::MatrixXd reduced(coordinates.unknowns(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    reduced.col(k) = -coordinates.reduce(at, by_points(result.forces, k));
  }
  const Eigen::MatrixXd rates = solver.solve_all(reduced);
  for (Eigen::Index k = 0; k < columns; ++k) {
    result.positions.col(k) = coordinates.motion(at, rates.col(k)).reshaped();
  }
  if (with_forces) result.forces += forces_along(objective, at, result.positions);
  return result;
}

}  // namespace pliant
