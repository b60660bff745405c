#include "pliant/material/density/softening_density.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

SofteningDensity::SofteningDensity(int component, double stiffness, double breaking)
    : component_(component), stiffness_(stiffness), breaking_(breaking) {
  PLIANT_ASSERT(stiffness >= 0 && breaking > 0, "links that break at some strain");
}

Lane SofteningDensity::largest(const Samples& samples) const {
  return samples.history.col(0).max(samples.strain.col(component_).abs());
}

// The energy of the links that break while the largest strain grows.
Lane SofteningDensity::lost(const Lane& from, const Lane& to) const {
  const double r = breaking_;
  const auto left = [r](const Lane& m) {
    return Lane((m.square() + 2 * r * m + 2 * r * r) * (-m / r).exp());
  };
  return stiffness_ / 2 * (left(from) - left(to));
}

void SofteningDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  const Lane strain = samples.strain.col(component_), before = samples.history.col(0);
  const Lane now = largest(samples);
  const Lane stiffness = stiffness_ * (-now / breaking_).exp();
  response.stored += stiffness / 2 * strain.square();
  response.work += lost(before, now);
  response.stress.col(component_) += stiffness * strain;
  response.tangent.col(component_ * samples.strain.cols() + component_) +=
      stiffness * (now > before).select(1 - now / breaking_, Lane::Ones());
}

void SofteningDensity::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                               Lane& work) const {
  const Lane before = samples.history.col(0), now = largest(samples);
  next.col(0) = now;
  work += lost(before, now);
}

std::unique_ptr<ParametricDensity> SofteningDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<SofteningDensity>(component_, values(0), values(1));
}

void SofteningDensity::differentiate(const Samples& samples, const StepTime&, int lane,
                                     int first_history, int first_parameter,
                                     SampleDerivatives& derivatives) const {
  const double strain = samples.strain(lane, component_), before = samples.history(lane, 0);
  const double now = std::max(before, std::abs(strain));
  const bool breaks = now > before;
  const double left = std::exp(-now / breaking_), stress = stiffness_ * strain * left;
  auto by_parameter = derivatives.stress_by_parameter.row(component_);
  by_parameter(first_parameter) += strain * left;
  by_parameter(first_parameter + 1) += stress * now / (breaking_ * breaking_);
  if (!breaks) derivatives.stress_by_history(component_, first_history) -= stress / breaking_;
  derivatives.next_by_strain(first_history, component_) = breaks ? std::copysign(1, strain) : 0;
  derivatives.next_by_history(first_history, first_history) = breaks ? 0 : 1;
}

}  // namespace pliant
