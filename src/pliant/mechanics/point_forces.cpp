#include "pliant/mechanics/point_forces.h"

namespace pliant {

void PointForces::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  if (control_ < 0) {
    add(forces_, at, derivatives);
  } else {
    add(at.controls.vector(control_, Eigen::Vector3d::Zero()) * shares_, at, derivatives);
  }
}

void PointForces::add(const Eigen::Matrix3Xd& forces, const Evaluation& at,
                      Derivatives& derivatives) const {
  derivatives.energy.stored -= forces.cwiseProduct(at.configuration.positions).sum();
  if (derivatives.gradient) *derivatives.gradient -= forces;
}

}  // namespace pliant
