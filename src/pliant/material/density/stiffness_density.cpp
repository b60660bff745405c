#include "pliant/material/density/stiffness_density.h"

namespace pliant {

StiffnessDensity::StiffnessDensity(int component, ScalarCurve stiffness)
    : component_(component), stiffness_(std::move(stiffness)) {}

void StiffnessDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  const auto strain = samples.strain.col(component_);
  auto stress = response.stress.col(component_);
  auto tangent = response.tangent.col(component_ * samples.strain.cols() + component_);
  if (stiffness_.kind() != CurveKind::hermite) {
    const double k1 = stiffness_.values()[0];
    const double k2 = stiffness_.kind() == CurveKind::affine ? stiffness_.values()[1] : 0;
    const Lane growth = k2 * strain.abs();
    response.stored += strain.square() * (k1 / 2 + growth / 3);
    stress += strain * (k1 + growth);
    tangent += k1 + 2 * growth;
    return;
  }
  for (int i = 0; i < kLanes; ++i) {
    const double k = stiffness_.value(strain(i));
    response.stored(i) += stiffness_.first_moment(strain(i));
    stress(i) += k * strain(i);
    tangent(i) += k + stiffness_.slope(strain(i)) * strain(i);
  }
}

void StiffnessDensity::advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const {}

Eigen::VectorXd StiffnessDensity::parameters() const {
  return Eigen::Map<const Eigen::VectorXd>(stiffness_.values().data(), stiffness_.size());
}

void StiffnessDensity::set_parameters(const Eigen::VectorXd& values) {
  stiffness_ = stiffness_.with_values(values.data());
}

void StiffnessDensity::differentiate(const Samples& samples, int lane, int, int first_parameter,
                                     SampleDerivatives& derivatives) const {
  const double strain = samples.strain(lane, component_);
  derivatives.stress_by_parameter.row(component_).segment(first_parameter, stiffness_.size()) +=
      strain * stiffness_.weights(strain).transpose();
}

}  // namespace pliant
