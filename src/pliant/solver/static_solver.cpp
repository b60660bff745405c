#include "pliant/solver/static_solver.h"

#include "pliant/solver/within_limits.h"

namespace pliant {

StaticSolver::StaticSolver(const System& system, const NewtonOptions& options)
    : system_(system), options_(options), workspace_(system) {}

NewtonSummary StaticSolver::find_equilibrium(State& state, const Controls& controls) {
  system_.coordinates().apply(controls, state.configuration);
  return minimize_within_limits(system_, {.from = state, .controls = controls}, options_,
                                workspace_, state.configuration);
}

double StaticSolver::accept(State& state) const {
  Eigen::VectorXd history;
  const double work = system_.advance_history(state.configuration, {state}, history).work;
  state.history = std::move(history);
  return work;
}

}  // namespace pliant
