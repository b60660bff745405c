#pragma once

#include <optional>
#include <vector>

#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/newton.h"

namespace pliant {

struct StaticPathOptions {
  NewtonOptions newton{.reuse_factor = true};
  int substeps = 1;        ///< equilibria per step of the schedule, at equal times, >= 1
  int max_halvings = 6;    ///< of a step whose equilibrium is not found
  Schedule schedule = {};  ///< what comes from outside; nothing where empty
  Parameters parameters = {};
  std::vector<int> by = {};  ///< parameters of the material that derivatives are wanted by
  /// Where an equilibrium is not stable its derivatives are those of a convex stand-in of the
  /// Hessian ([T] 3.4.1 modifies it likewise), instead of an error.
  bool convex_sensitivities = false;
};

/// An equilibrium of a quasi-static path.
struct PathEquilibrium {
  double time = 0;       ///< s
  NewtonSummary newton;  ///< of the last equilibrium; iterations are those of the whole step
  int equilibria = 0;    ///< found during the step
  double search_seconds = 0, derivative_seconds = 0;
  SearchCosts costs;        ///< of the search
  double work = 0;          ///< done against friction during the step (J)
  double outside = 0;       ///< done from outside; not counted where derivatives are asked for (J)
  Eigen::Matrix3Xd forces;  ///< dE / d points (N): on points moved from outside what moves them

  EquilibriumDerivatives by_parameter;  ///< empty where no derivatives were asked for

  /// A way between equilibria.
  struct Way {
    State from;
    Controls controls;
    Configuration to;
  };
  std::vector<Way> ways;  ///< of the step whose derivatives are still to be taken
};

/// A quasi-static path of a system: equilibria at one time after the other, under what the schedule
/// says then, each with the friction that the ones before have left.
///
/// A step whose equilibrium is not found is halved, and its halves again. Parameters enter through
/// all of the path: (dF/dx) dx/dp = -dF/dp ([T] Eq. 3.7), back-substituted in the factor of the
/// Hessian at the equilibrium, with the derivatives of what friction remembers carried along.
/// These derivatives hold for one pattern of branches: no element turns around a step earlier or
/// later. The motion that the schedule prescribes does not depend on parameters.
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
  ///         derivatives are asked for and it is not stable; the path then stands at the last
  ///         one accepted, which may lie between two times of the schedule
  /// @param guess  where the search begins; without points: where the path stands
  PathEquilibrium step(double time, const Configuration& guess = {});

  /// @name A step in two parts, of which each may go on without the other
  ///
  /// The search of a step needs no derivatives of those before: one thread may search while another
  /// differentiates, each in the order of the steps.
  /// @{
  PathEquilibrium search(double time, const Configuration& guess = {});
  void differentiate(PathEquilibrium& point);
  /// @}

  const State& state() const { return state_; }
  /// Goes on from another state of the system, on whose history no parameter has an influence yet.
  void go_on_from(const State& state);
  /// d history / d parameters of the state; empty without derivatives.
  const Eigen::MatrixXd& history_by_parameter() const { return history_by_parameter_; }

 private:
  Controls controls_at(double time) const {
    return options_.schedule ? options_.schedule(time) : Controls{};
  }
  void search(double time, const Configuration& guess, PathEquilibrium& point);
  void reach(double time, int halvings, PathEquilibrium& point);
  bool find_equilibrium(const Controls& controls, PathEquilibrium& point, Configuration& at);
  void accept(double time, Controls controls, Configuration at, PathEquilibrium& point);
  void differentiate(const PathEquilibrium::Way& way, PathEquilibrium& point);

  const System& system_;
  StaticPathOptions options_;
  Workspace of_search_;
  std::optional<Workspace> of_derivatives_;
  State state_;
  Eigen::MatrixXd history_by_parameter_;
};

}  // namespace pliant
