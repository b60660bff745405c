#include "pliant/contact/coulomb.h"

namespace pliant {

SlipEnergy slip_energy(const Eigen::Vector3d& slip, double bound, const Eigen::Matrix3d& plane) {
  const double length = slip.norm();
  if (length < kSlipLength) {
    const double stiffness = bound / kSlipLength;
    return {stiffness * length * length / 2, stiffness * slip, stiffness * plane};
  }
  const Eigen::Vector3d along = slip / length;
  return {bound * (length - kSlipLength / 2), bound * along,
          bound / length * (plane - along * along.transpose())};
}

Eigen::Vector3d elastic_slip(const Eigen::Vector3d& slip) {
  const double length = slip.norm();
  return length <= kSlipLength ? slip : (kSlipLength / length * slip).eval();
}

}  // namespace pliant
