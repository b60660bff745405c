#include "pliant/material/density/plastic_density.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

PlasticParameters PlasticParameters::of(const Eigen::VectorXd& values) {
  PlasticParameters plastic{values(0), values(1)};
  if (values.size() > 2) plastic.saturation = values(2);
  return plastic;
}

PlasticDensity::PlasticDensity(int component, const PlasticParameters& plastic)
    : component_(component), plastic_(plastic) {
  PLIANT_ASSERT(plastic.stiffness >= 0 && plastic.yield >= 0 && plastic.saturation >= 0,
                "an elastic range has a stiffness and a width");
}

// That of the end of the step.
Lane PlasticDensity::plastic_strain(const Samples& samples) const {
  const Lane strain = samples.strain.col(component_);
  const Lane at_yield =
      samples.history.col(0).max(strain - plastic_.yield).min(strain + plastic_.yield);
  return at_yield.max(-plastic_.saturation).min(plastic_.saturation);
}

Lane PlasticDensity::dissipation(const Lane& from, const Lane& to) const {
  return plastic_.stiffness * plastic_.yield * (to - from).abs();
}

void PlasticDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  const double k = plastic_.stiffness;
  const Lane before = samples.history.col(0), now = plastic_strain(samples);
  const Lane elastic = samples.strain.col(component_) - now;
  response.stored += k / 2 * elastic.square();
  response.work += dissipation(before, now);
  response.stress.col(component_) += k * elastic;
  response.tangent.col(component_ * samples.strain.cols() + component_) +=
      (now == before || now.abs() >= plastic_.saturation).select(Lane::Constant(k), Lane::Zero());
}

void PlasticDensity::add_stored(const Samples& samples, Lane& stored) const {
  const Lane elastic = samples.strain.col(component_) - plastic_strain(samples);
  stored += plastic_.stiffness / 2 * elastic.square();
}

void PlasticDensity::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                             Lane& work) const {
  const Lane before = samples.history.col(0);
  next.col(0) = plastic_strain(samples);
  work += dissipation(before, next.col(0));
}

Eigen::VectorXd PlasticDensity::parameters() const {
  if (std::isinf(plastic_.saturation)) return Eigen::Vector2d(plastic_.stiffness, plastic_.yield);
  return Eigen::Vector3d(plastic_.stiffness, plastic_.yield, plastic_.saturation);
}

std::unique_ptr<ParametricDensity> PlasticDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<PlasticDensity>(component_, PlasticParameters::of(values));
}

void PlasticDensity::differentiate(const Samples& samples, const StepTime&, int lane,
                                   int first_history, int first_parameter,
                                   SampleDerivatives& derivatives) const {
  const double k = plastic_.stiffness;
  const double before = samples.history(lane, 0), now = plastic_strain(samples)(lane);
  const double elastic = samples.strain(lane, component_) - now;
  const double side = std::copysign(1.0, elastic);
  // Of the plastic strain by strain, by the one before, by yield and by saturation.
  double by_strain = 0, by_before = 0, by_yield = 0, by_saturation = 0;
  if (std::abs(now) >= plastic_.saturation) {
    by_saturation = std::copysign(1.0, now);
  } else if (now == before) {
    by_before = 1;
  } else {
    by_strain = 1;
    by_yield = -side;
  }
  derivatives.stress_by_history(component_, first_history) -= k * by_before;
  auto stress_by = derivatives.stress_by_parameter.row(component_);
  stress_by(first_parameter) += elastic;
  stress_by(first_parameter + 1) -= k * by_yield;
  derivatives.next_by_strain(first_history, component_) = by_strain;
  derivatives.next_by_history(first_history, first_history) = by_before;
  derivatives.next_by_parameter(first_history, first_parameter + 1) = by_yield;
  if (std::isinf(plastic_.saturation)) return;
  stress_by(first_parameter + 2) -= k * by_saturation;
  derivatives.next_by_parameter(first_history, first_parameter + 2) = by_saturation;
}

}  // namespace pliant
