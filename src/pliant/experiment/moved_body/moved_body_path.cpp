#include "pliant/experiment/moved_body/moved_body_path.h"

#include <utility>

#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/within_limits.h"

namespace pliant {
namespace {

constexpr int kMostHalvings = 8;

}  // namespace

MovedBodyPath::MovedBodyPath(const HeldBody& body, BodyPathOptions options)
    : body_(body),
      options_(std::move(options)),
      workspace_(body.system()),
      state_(body.system().initial_state(options_.parameters)),
      history_by_(Eigen::MatrixXd::Zero(state_.history.size(), std::ssize(options_.by))) {}

std::optional<Configuration> MovedBodyPath::equilibrium(Configuration guess,
                                                        const Eigen::Vector3d& shift) {
  const Controls controls = body_.controls(shift);
  body_.system().coordinates().apply(controls, guess);
  const NewtonOptions newton{.tolerance = body_.tolerance(), .stop = options_.stop};
  const NewtonSummary found = minimize_within_limits(
      body_.system(), {state_, options_.parameters, controls}, newton, workspace_, guess);
  return found.converged ? std::optional(std::move(guess)) : std::nullopt;
}

std::optional<BodyPoint> MovedBodyPath::go_to(const Eigen::Vector3d& shift,
                                              const Eigen::Matrix3Xd* guess) {
  if (guess) {
    Configuration near = state_.configuration;
    near.positions = *guess;
    if (const auto found = equilibrium(std::move(near), shift)) return accept(*found, shift);
  }
  return step(shift, 0);
}

std::optional<BodyPoint> MovedBodyPath::step(const Eigen::Vector3d& shift, int halvings) {
  if (const auto found = equilibrium(state_.configuration, shift)) return accept(*found, shift);
  if (halvings == kMostHalvings) return std::nullopt;
  if (!step((shift_ + shift) / 2, halvings + 1)) return std::nullopt;
  return step(shift, halvings + 1);
}

// An equilibrium that nothing can be said of but where it is does not count as found.
std::optional<BodyPoint> MovedBodyPath::accept(const Configuration& at,
                                               const Eigen::Vector3d& shift) {
  const System& system = body_.system();
  const Controls controls = body_.controls(shift);
  const Conditions under{state_, options_.parameters, controls};
  const Objective objective(system, under);
  BodyPoint point{at.positions, {}, {}, {}};
  point.force = body_.force(objective.gradient(at));
  if (!options_.by.empty()) {
    if (!differentiate(objective, at, point)) return std::nullopt;
    system.advance_sensitivity(at, under, options_.by, point.positions_by, history_by_);
  }
  State next = state_;
  system.advance_history(at, under, next.history);
  next.configuration = at;
  std::swap(state_, next);
  shift_ = shift;
  return point;
}

// With the energy E at nodes x and moves s of what is led, equilibrium is E_x = 0 and the force
// E_s. So that dx/dp = -H^-1 E_xp, and the force changes by E_sp - E_sx H^-1 E_xp = u^T (E_xp,
// E_sp): u is how all nodes go as s does, three solutions in place of one a parameter.
bool MovedBodyPath::differentiate(const Objective& objective, const Configuration& at,
                                  BodyPoint& point) {
  Eigen::Matrix3Xd gradient;
  if (!factorize_at(objective, at, gradient, workspace_)) return false;
  EquilibriumDerivatives by =
      differentiate_equilibrium(objective, at, options_.by, history_by_, *workspace_.solver,
                                /*with_forces=*/false);
  const Coordinates& coordinates = body_.system().coordinates();
  Eigen::MatrixXd motions = body_.moves();
  const Eigen::MatrixXd forces = forces_along(objective, at, motions);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Map<const Eigen::Matrix3Xd> along(forces.col(axis).data(), 3, at.positions.cols());
    const Eigen::VectorXd answer =
        workspace_.solver->solve_all(-coordinates.reduce(at, along)).col(0);
    motions.col(axis) += coordinates.motion(at, answer).reshaped();
  }
  point.force_by = motions.transpose() * by.forces;
  point.positions_by = std::move(by.positions);
  return true;
}

}  // namespace pliant
