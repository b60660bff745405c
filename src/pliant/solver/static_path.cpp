#include "pliant/solver/static_path.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"

namespace pliant {
namespace {

std::string at_time(double time) { return " at " + std::to_string(time) + " s"; }

Eigen::Map<const Eigen::Matrix3Xd> by_points(const Eigen::MatrixXd& all, Eigen::Index column) {
  return {all.col(column).data(), 3, all.rows() / 3};
}

}  // namespace

StaticPath::StaticPath(const System& system, const StaticPathOptions& options)
    : StaticPath(system, options, system.initial_state()) {
  if (!options.sensitivities) return;
  // The initial state was brought from the rest shape in one go, by points that no parameter moves.
  State rest = state_;
  rest.history.setZero();
  const Eigen::MatrixXd unmoved =
      Eigen::MatrixXd::Zero(3 * system.points(), system.parameter_count());
  system.advance_sensitivity(state_.configuration, rest, unmoved, history_by_parameter_);
}

StaticPath::StaticPath(const System& system, const StaticPathOptions& options, State start)
    : system_(system),
      options_(options),
      hessian_(system.make_hessian()),
      solver_(hessian_.matrix),
      state_(std::move(start)) {
  PLIANT_ASSERT(options.substeps >= 1, "a step has an equilibrium at its end");
  if (!options.sensitivities) return;
  history_by_parameter_ = Eigen::MatrixXd::Zero(state_.history.size(), system.parameter_count());
}

void StaticPath::go_on_from(const State& state) {
  state_ = state;
  if (options_.sensitivities) history_by_parameter_.setZero();
}

PathPoint StaticPath::step(double time) {
  PLIANT_ASSERT(time >= state_.time, "a path goes forward in time");
  const double start = state_.time;
  PathPoint point;
  for (int i = 1; i <= options_.substeps; ++i) {
    const double part = static_cast<double>(i) / options_.substeps;
    reach(i == options_.substeps ? time : start + part * (time - start), 0, point);
  }
  return point;
}

void StaticPath::reach(double time, int halvings, PathPoint& point) {
  Configuration at;
  if (find_equilibrium(time, point, at)) {
    accept(time, std::move(at), point);
    return;
  }
  const double middle = (state_.time + time) / 2;
  if (halvings == options_.max_halvings || middle == state_.time) {
    throw SolverError("the equilibrium" + at_time(time), point.newton.iterations,
                      point.newton.residual);
  }
  reach(middle, halvings + 1, point);
  reach(time, halvings + 1, point);
}

bool StaticPath::find_equilibrium(double time, PathPoint& point, Configuration& at) {
  at = state_.configuration;
  system_.drive(time, at);
  const NewtonSummary found =
      minimize(Objective(system_, state_), options_.newton, solver_, hessian_, at);
  const NewtonSummary before = point.newton;
  point.newton = found;
  point.newton.iterations += before.iterations;
  point.newton.factorizations += before.factorizations;
  point.newton.linear_iterations += before.linear_iterations;
  return found.converged;
}

void StaticPath::accept(double time, Configuration at, PathPoint& point) {
  point.time = time;
  ++point.equilibria;
  if (options_.sensitivities) {
    differentiate(at, point);
    system_.advance_sensitivity(at, state_, point.positions_by_parameter, history_by_parameter_);
  } else {
    point.forces = Objective(system_, state_).gradient(at);
  }
  Eigen::VectorXd history;
  point.work += system_.advance_history(at, state_, {}, history);
  state_.time = time;
  state_.configuration = std::move(at);
  state_.history = std::move(history);
}

void StaticPath::differentiate(const Configuration& at, PathPoint& point) {
  const Coordinates& coordinates = system_.coordinates();
  // Newton's own factor belongs to the iterate before the last, and may be shifted.
  Objective(system_, state_).linearize(at, Curvature::exact, point.forces, hessian_);
  if (!solver_.factorize(hessian_.matrix)) {
    throw SolverError("the sensitivity of the equilibrium" + at_time(point.time) +
                          ", which is not stable (its Hessian is not positive definite)",
                      point.newton.iterations, point.newton.residual);
  }

  const Eigen::Index rows = 3 * system_.points();
  Eigen::MatrixXd& forces = point.forces_by_parameter;
  Eigen::MatrixXd& positions = point.positions_by_parameter;
  forces.setZero(rows, system_.parameter_count());
  positions.resize(rows, system_.parameter_count());
  system_.add_force_sensitivity(at, state_, history_by_parameter_, forces);
  Eigen::VectorXd rates;
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    solver_.solve(-coordinates.reduce(at, by_points(forces, k)), rates);
    positions.col(k) = coordinates.motion(at, rates).reshaped();
  }
  forces += forces_along(at, positions);
}

// Central differences along each motion: the Hessian has no rows for points that are moved from
// outside. The motion is scaled to a small part of the distance between neighbours, so that strains
// change by about 1e-6, far less than friction takes to turn around.
Eigen::MatrixXd StaticPath::forces_along(const Configuration& at,
                                         const Eigen::MatrixXd& motions) const {
  const Eigen::Vector3d extent =
      at.positions.rowwise().maxCoeff() - at.positions.rowwise().minCoeff();
  const double distance = extent.norm() / std::sqrt(static_cast<double>(system_.points()));
  const Objective objective(system_, state_);
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(motions.rows(), motions.cols());
  for (Eigen::Index k = 0; k < motions.cols(); ++k) {
    const double largest = motions.col(k).cwiseAbs().maxCoeff();
    if (largest == 0) continue;
    const double length = 1e-6 * distance / largest;
    Configuration forward = at, backward = at;
    forward.positions += length * by_points(motions, k);
    backward.positions -= length * by_points(motions, k);
    changes.col(k) =
        ((objective.gradient(forward) - objective.gradient(backward)) / (2 * length)).reshaped();
  }
  return changes;
}

}  // namespace pliant
