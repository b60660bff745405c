#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/solver/objective.h"
#include "pliant/solver/workspace.h"

namespace pliant {

/// How an equilibrium changes with the parameters of its system: 3 points x parameters.
struct EquilibriumDerivatives {
  Eigen::MatrixXd positions;  ///< (dF/dx) dx/dp = -dF/dp ([T] Eq. 3.7)
  Eigen::MatrixXd forces;     ///< total: dF/dx dx/dp + dF/dp ([T] Eq. 3.8); or dF/dp alone
};

/// How forces change as points move: H times each motion (3 points x motions), points that are
/// moved from outside included.
Eigen::MatrixXd forces_along(const Objective& objective, const Configuration& at,
                             const Eigen::MatrixXd& motions);

/// Factorises the Hessian at an equilibrium: the exact one or, where it is not positive definite,
/// its convex stand-in ([T] 3.4.1 modifies it likewise).
/// @param gradient  gets dE / d points (N)
/// @return which was factorised; nothing where neither could be
std::optional<Curvature> factorize_at(const Objective& objective, const Configuration& at,
                                      Eigen::Matrix3Xd& gradient, Workspace& workspace);

/// Derivatives of an equilibrium by some of the parameters of its system.
/// @param by                    parameters of the system
/// @param history_by_parameter  of what its potentials remember; rows of the whole history
/// @param solver                with the Hessian at the equilibrium, factorised
/// @param with_forces           whether forces are total ones, which cost two evaluations a
///                              parameter, or those at fixed positions
EquilibriumDerivatives differentiate_equilibrium(const Objective& objective,
                                                 const Configuration& at,
                                                 const std::vector<int>& by,
                                                 const Eigen::MatrixXd& history_by_parameter,
                                                 const LinearSolver& solver,
                                                 bool with_forces = true);

}  // namespace pliant
