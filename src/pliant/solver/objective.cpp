#include "pliant/solver/objective.h"

namespace pliant {

void Objective::evaluate(const Configuration& at, Curvature curvature,
                         Derivatives& derivatives) const {
  system_.evaluate(at, under_, curvature, derivatives);
  const Evaluation own{.configuration = at, .time = under_.time, .curvature = curvature};
  for (const Potential* potential : of_step_) potential->evaluate(own, derivatives);
}

Energy Objective::energy(const Configuration& at) const {
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
  gradient.setZero(3, system_.points());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  evaluate(at, Curvature::exact, derivatives);
  return derivatives.energy;
}

Energy Objective::linearize(const Configuration& at, Curvature curvature,
                            Eigen::Matrix3Xd& gradient, Hessian& hessian) const {
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

}  // namespace pliant
