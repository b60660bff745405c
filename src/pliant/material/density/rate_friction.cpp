#include "pliant/material/density/rate_friction.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr double kSlowest = 1e-6;  // r0: strains a second

}  // namespace

RateFriction::RateFriction(int component, const Eigen::Vector4d& values)
    : component_(component),
      values_(values),
      slowest_(component, DahlParameters{values(0), values(1), values(2)}) {
  PLIANT_ASSERT(values(3) >= 0, "friction that does not fall with the rate");
}

void RateFriction::add(const Samples& samples, const StepTime& time, Response& response) const {
  const Lane factor = 1 + values_(3) * samples.history.col(1);
  const Lane from = samples.history.col(0) / factor;
  Response own(static_cast<int>(samples.strain.cols()));
  slowest_.add({samples.strain, samples.last, samples.before, LaneView(from.data(), kLanes, 1)},
               time, own);
  const Eigen::Index slope = component_ * samples.strain.cols() + component_;
  response.work += factor * own.work;
  response.stress.col(component_) += factor * own.stress.col(component_);
  response.tangent.col(slope) += factor * own.tangent.col(slope);
}

void RateFriction::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                           Lane& work) const {
  Response response(static_cast<int>(samples.strain.cols()));
  add(samples, time, response);
  const Lane way = samples.strain.col(component_) - samples.last.col(component_);
  next.col(0) = response.stress.col(component_);
  next.col(1) = time.seconds > 0 ? Lane((1 + way.abs() / (kSlowest * time.seconds)).log())
                                 : Lane(samples.history.col(1));
  work += response.work;
}

std::unique_ptr<ParametricDensity> RateFriction::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<RateFriction>(component_, values);
}

void RateFriction::differentiate(const Samples& samples, const StepTime& time, int lane,
                                 int first_history, int first_parameter,
                                 SampleDerivatives& derivatives) const {
  const double logarithm = samples.history(lane, 1), factor = 1 + values_(3) * logarithm;
  const DahlParameters dahl{factor * values_(0), factor * values_(1), values_(2)};
  const double strain = samples.strain(lane, component_), last = samples.last(lane, component_);
  const FrictionStress friction = friction_stress(dahl, strain, {last, samples.history(lane, 0)});
  const auto& [by_a, by_b, by_tau] = friction.parameters;
  const double by_factor = values_(0) * by_a + values_(1) * by_b;
  const Eigen::RowVector4d by_parameter(factor * by_a, factor * by_b, by_tau,
                                        logarithm * by_factor);
  derivatives.stress_by_last(component_, component_) += friction.from_strain;
  derivatives.stress_by_history(component_, first_history) += friction.from_stress;
  derivatives.stress_by_history(component_, first_history + 1) += values_(3) * by_factor;
  derivatives.stress_by_parameter.row(component_).segment<4>(first_parameter) += by_parameter;
  derivatives.next_by_strain(first_history, component_) = friction.slope;
  derivatives.next_by_last(first_history, component_) = friction.from_strain;
  derivatives.next_by_history(first_history, first_history) = friction.from_stress;
  derivatives.next_by_history(first_history, first_history + 1) = values_(3) * by_factor;
  derivatives.next_by_parameter.row(first_history).segment<4>(first_parameter) = by_parameter;
  if (!(time.seconds > 0)) {
    derivatives.next_by_history(first_history + 1, first_history + 1) = 1;
    return;
  }
  const double way = strain - last;
  const double rate_by_strain = std::copysign(1 / (kSlowest * time.seconds + std::abs(way)), way);
  derivatives.next_by_strain(first_history + 1, component_) = rate_by_strain;
  derivatives.next_by_last(first_history + 1, component_) = -rate_by_strain;
}

}  // namespace pliant
