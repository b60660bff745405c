#include "pliant/solver/objective.h"

namespace pliant {

void Objective::evaluate(const Configuration& at, Curvature curvature,
                         Derivatives& derivatives) const {
  system_.evaluate(at, under_, curvature, derivatives);
  const Evaluation own{.configuration = at, .time = under_.time, .curvature = curvature};
  for (const Potential* potential : of_step_) potential->evaluate(own, derivatives);
}

Energy Objective::energy(const Configuration& at) const {
  const Timed counted = timed(&SearchCosts::energies);
  Derivatives derivatives;
  evaluate(at, Curvature::exact, derivatives);
  return derivatives.energy;
}

Eigen::Matrix3Xd Objective::gradient(const Configuration& at) const {
  Eigen::Matrix3Xd gradient;
  evaluate(at, gradient);
  return gradient;
}

Energy Objective::evaluate(const Configuration& at, Eigen::Matrix3Xd& gradient) const {
  const Timed counted = timed(&SearchCosts::energies);
  gradient.setZero(3, system_.points());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  evaluate(at, Curvature::exact, derivatives);
  return derivatives.energy;
}

Energy Objective::linearize(const Configuration& at, Curvature curvature,
                            Eigen::Matrix3Xd& gradient, Hessian& hessian) const {
  const Timed counted = timed(&SearchCosts::assembly);
  gradient.setZero(3, system_.points());
  hessian.matrix.set_zero();
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  derivatives.hessian = &hessian;
  evaluate(at, curvature, derivatives);
  system_.coordinates().add_rotation_terms(at, gradient, hessian.matrix);
  system_.coordinates().hold_neutral_rotations(at, hessian.matrix);
  system_.coordinates().decouple_prescribed_axes(hessian.matrix);
  return derivatives.energy;
}

std::optional<Eigen::Matrix3Xd> Objective::made_way(const Eigen::Matrix3Xd& led) const {
  const Timed counted = timed(&SearchCosts::ways);
  return system_.made_way(led, under_);
}

WayLimits Objective::way_limits(const Configuration& from, const Configuration& to,
                                double kept) const {
  const Timed counted = timed(&SearchCosts::ways);
  return system_.way_limits(from, to, under_, kept);
}

Energy Objective::advance_history(const Configuration& at, Eigen::VectorXd& history) const {
  const Timed counted = timed(&SearchCosts::history);
  return system_.advance_history(at, under_, history);
}

}  // namespace pliant
