#include "pliant/mechanics/point_targets.h"

namespace pliant {

PointTargets::PointTargets(Eigen::VectorXd stiffness, Eigen::Matrix3Xd targets)
    : stiffness_(std::move(stiffness)), targets_(std::move(targets)) {}

double PointTargets::energy(const Eigen::Matrix3Xd& positions) const {
  return (positions - targets_).colwise().squaredNorm().dot(stiffness_) / 2;
}

void PointTargets::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  const Eigen::Matrix3Xd& positions = at.configuration.positions;
  derivatives.energy.stored += energy(positions);
  if (derivatives.gradient) {
    *derivatives.gradient += (positions - targets_) * stiffness_.asDiagonal();
  }
  if (!derivatives.hessian) return;
  Hessian& hessian = *derivatives.hessian;
  for (int i = 0; i < stiffness_.size(); ++i) {
    if (hessian.coordinates.is_free(i)) {
      hessian.matrix.add_to_diagonal(hessian.coordinates.row(i), stiffness_(i));
    } else {
      hessian.coordinates.add_coupling(at.configuration, i, i,
                                       stiffness_(i) * Eigen::Matrix3d::Identity(), hessian.matrix);
    }
  }
}

}  // namespace pliant
