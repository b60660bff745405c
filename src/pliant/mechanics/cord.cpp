#include "pliant/mechanics/cord.h"

#include <algorithm>

namespace pliant {

Cord::Cord(int point, double stiffness, double length, const Eigen::Vector3d& end, int control)
    : point_(point), stiffness_(stiffness), length_(length), end_(end), control_(control) {}

Eigen::Vector3d Cord::force(const Configuration& configuration, const Controls& controls) const {
  const Eigen::Vector3d way = controls.vector(control_, end_) - configuration.positions.col(point_);
  const double distance = way.norm();
  if (distance <= length_) return Eigen::Vector3d::Zero();
  return stiffness_ * (1 - length_ / distance) * way;
}

void Cord::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  const Eigen::Vector3d way =
      at.controls.vector(control_, end_) - at.configuration.positions.col(point_);
  const double distance = way.norm();
  if (distance < length_ || (distance == length_ && length_ > 0)) return;
  const double stretch = distance - length_;
  derivatives.energy.stored += stiffness_ * stretch * stretch / 2;
  if (derivatives.gradient)
    derivatives.gradient->col(point_) -= force(at.configuration, at.controls);
  if (!derivatives.hessian) return;
  // A cord without length is as stiff in all directions.
  const double across = length_ > 0 ? stretch / distance : 1;
  const Eigen::Vector3d along = length_ > 0 ? (way / distance).eval() : Eigen::Vector3d::Zero();
  derivatives.hessian->coordinates.add_coupling(
      at.configuration, point_, point_,
      stiffness_ *
          (across * Eigen::Matrix3d::Identity() + (1 - across) * along * along.transpose()),
      derivatives.hessian->matrix);
}

}  // namespace pliant
