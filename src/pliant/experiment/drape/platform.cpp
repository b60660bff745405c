#include "pliant/experiment/drape/platform.h"

namespace pliant {

void Platform::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  if (height_ >= at.controls.vectors.cols()) return;
  const double height = at.controls.vectors(2, height_);
  const Eigen::Matrix3Xd& positions = at.configuration.positions;
  for (int i = 0; i < springs_.size(); ++i) {
    const double depth = height - positions(2, i);
    if (depth <= 0) continue;
    derivatives.energy.stored += springs_(i) * depth * depth / 2;
    if (derivatives.gradient) (*derivatives.gradient)(2, i) -= springs_(i) * depth;
    if (!derivatives.hessian) continue;
    Hessian& hessian = *derivatives.hessian;
    if (hessian.coordinates.is_prescribed(i)) continue;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    hessian.coordinates.add_coupling(at.configuration, i, i, springs_(i) * up * up.transpose(),
                                     hessian.matrix);
  }
}

}  // namespace pliant
