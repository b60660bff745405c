#include "pliant/solver/static_solver.h"

namespace pliant {

StaticSolver::StaticSolver(const System& system, const NewtonOptions& options)
    : system_(system),
      options_(options),
      hessian_(system.make_hessian()),
      solver_(hessian_.matrix) {}

NewtonSummary StaticSolver::find_equilibrium(State& state) {
  system_.drive(state.time, state.configuration);
  const Objective objective(system_, state);
  return minimize(objective, options_, solver_, hessian_, state.configuration);
}

double StaticSolver::accept(State& state) const {
  Eigen::VectorXd history;
  const double work = system_.advance_history(state.configuration, state, {}, history);
  state.history = std::move(history);
  return work;
}

}  // namespace pliant
