#include "pliant/material/density/closed_form_density.h"

#include <cstddef>
#include <utility>

namespace pliant {

ClosedFormDensity::ClosedFormDensity(int component, EnergyFunction energy, Eigen::VectorXd values,
                                     bool linear)
    : component_(component), energy_(energy), values_(std::move(values)), linear_(linear) {}

void ClosedFormDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  const auto diagonal = component_ * samples.strain.cols() + component_;
  for (int lane = 0; lane < kLanes; ++lane) {
    const EnergyAt at = energy_(samples.strain(lane, component_), values_);
    response.stored(lane) += at.energy;
    response.stress(lane, component_) += at.stress;
    response.tangent(lane, diagonal) += at.tangent;
  }
}

std::unique_ptr<ParametricDensity> ClosedFormDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<ClosedFormDensity>(component_, energy_, values, linear_);
}

void ClosedFormDensity::differentiate(const Samples& samples, const StepTime&, int lane, int,
                                      int first_parameter, SampleDerivatives& derivatives) const {
  const EnergyAt at = energy_(samples.strain(lane, component_), values_);
  for (Eigen::Index i = 0; i < values_.size(); ++i) {
    const auto number = static_cast<std::size_t>(i);
    derivatives.stored_by_parameter(first_parameter + i) += at.energy_by_parameter[number];
    derivatives.stress_by_parameter(component_, first_parameter + i) +=
        at.stress_by_parameter[number];
  }
}

}  // namespace pliant
