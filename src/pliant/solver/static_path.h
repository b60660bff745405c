#pragma once

#include "pliant/math/sparse_cholesky.h"
#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/newton.h"

namespace pliant {

struct StaticPathOptions {
  NewtonOptions newton{.reuse_factor = true};
  int substeps = 1;            ///< equilibria per step of the schedule, at equal times, >= 1
  int max_halvings = 6;        ///< of a step whose equilibrium is not found
  bool sensitivities = false;  ///< derivatives by the parameters of the material
  /// Where an equilibrium is not stable its derivatives are those of a convex stand-in of the
  /// Hessian ([T] 3.4.1 modifies it likewise), instead of an error.
  bool convex_sensitivities = false;
};

/// An equilibrium of a quasi-static path.
struct PathEquilibrium {
  double time = 0;       ///< s
  NewtonSummary newton;  ///< of the last equilibrium; iterations are those of the whole step
  int equilibria = 0;    ///< found during the step
  double derivative_seconds = 0;  ///< that their derivatives took
  double work = 0;                ///< done against friction during the step (J)
  Eigen::Matrix3Xd forces;  ///< dE / d points (N): on points moved from outside what moves them

  EquilibriumDerivatives by_parameter;  ///< empty where no derivatives were asked for
};

/// A quasi-static path of a system: equilibria at one time after the other, under what its drives
/// say then, each with the friction that the ones before have left.
///
/// A step whose equilibrium is not found is halved, and its halves again. Parameters enter through
/// all of the path: (dF/dx) dx/dp = -dF/dp ([T] Eq. 3.7), back-substituted in the factor of the
/// Hessian at the equilibrium, with the derivatives of what friction remembers carried along.
/// These derivatives hold for one pattern of branches: no element turns around a step earlier or
/// later. The motion that drives prescribe does not depend on parameters.
class StaticPath {
 public:
  /// From the system's initial state, at time 0. `system` outlives the path.
  explicit StaticPath(const System& system, const StaticPathOptions& options = {});
  /// From a given state.
  /// @param history_by_parameter  d history / d parameters of it; empty: no parameter has an
  ///                              influence on it yet
  StaticPath(const System& system, const StaticPathOptions& options, State start,
             Eigen::MatrixXd history_by_parameter = {});

  /// Goes on to the equilibrium at a later time and accepts it.
  /// @throws SolverError when an equilibrium is not found, even of the smallest step, or when
  ///         sensitivities are asked for and it is not stable; the path then stands at the last
  ///         one accepted, which may lie between two times of the schedule
  /// @param guess  where the search begins; without points: where the path stands
  PathEquilibrium step(double time, const Configuration& guess = {});

  const State& state() const { return state_; }
  /// Goes on from another state of the system, on whose history no parameter has an influence yet.
  void go_on_from(const State& state);
  /// d history / d parameters of the state; empty without sensitivities.
  const Eigen::MatrixXd& history_by_parameter() const { return history_by_parameter_; }

 private:
  void reach(double time, int halvings, PathEquilibrium& point);
  bool find_equilibrium(double time, PathEquilibrium& point, Configuration& at);
  void accept(double time, Configuration at, PathEquilibrium& point);

  const System& system_;
  StaticPathOptions options_;
  Hessian hessian_;
  SparseCholesky solver_;
  State state_;
  Eigen::MatrixXd history_by_parameter_;
};

}  // namespace pliant
