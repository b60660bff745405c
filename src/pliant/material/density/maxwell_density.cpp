#include "pliant/material/density/maxwell_density.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

/// What of a stress is left at the end of a step, and what of a strain is felt there.
struct MaxwellDensity::Step {
  double left, felt;
  double left_by_time = 0, felt_by_time = 0;

  Step(double seconds, double time) {
    const double share = seconds / time;
    left = std::exp(-share);
    felt = share == 0 ? 1 : -std::expm1(-share) / share;
    if (!std::isfinite(share)) return;
    left_by_time = left * share / time;
    felt_by_time = (felt - left) / time;
  }
};

MaxwellDensity::MaxwellDensity(int component, double stiffness, double time)
    : component_(component), stiffness_(stiffness), time_(time) {
  PLIANT_ASSERT(stiffness >= 0 && time > 0, "a spring and a dashpot");
}

Lane MaxwellDensity::stored_at(const Lane& stress) const {
  return stiffness_ == 0 ? Lane::Zero() : Lane(stress.square() / (2 * stiffness_));
}

void MaxwellDensity::add(const Samples& samples, const StepTime& time, Response& response) const {
  const Step step(time.seconds, time_);
  const Lane from = samples.history.col(0);
  const Lane way = samples.strain.col(component_) - samples.last.col(component_);
  const double slope = stiffness_ * step.felt;
  const Lane stress = step.left * from + slope * way, stored = stored_at(stress);
  response.stored += stored;
  response.work += step.left * from * way + slope / 2 * way.square() - (stored - stored_at(from));
  response.stress.col(component_) += stress;
  response.tangent.col(component_ * samples.strain.cols() + component_) += slope;
}

// At the last step: how it gets from there is a matter of time.
void MaxwellDensity::add_stored(const Samples& samples, Lane& stored) const {
  stored += stored_at(samples.history.col(0));
}

void MaxwellDensity::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                             Lane& work) const {
  Response response(static_cast<int>(samples.strain.cols()));
  add(samples, time, response);
  next.col(0) = response.stress.col(component_);
  work += response.work;
}

std::unique_ptr<ParametricDensity> MaxwellDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<MaxwellDensity>(component_, values(0), values(1));
}

void MaxwellDensity::differentiate(const Samples& samples, const StepTime& time, int lane,
                                   int first_history, int first_parameter,
                                   SampleDerivatives& derivatives) const {
  const Step step(time.seconds, time_);
  const double way = samples.strain(lane, component_) - samples.last(lane, component_);
  const double from = samples.history(lane, 0), slope = stiffness_ * step.felt;
  const Eigen::RowVector2d by_parameter(
      step.felt * way, step.left_by_time * from + stiffness_ * step.felt_by_time * way);
  derivatives.stress_by_last(component_, component_) -= slope;
  derivatives.stress_by_history(component_, first_history) += step.left;
  derivatives.stress_by_parameter.row(component_).segment<2>(first_parameter) += by_parameter;
  derivatives.next_by_strain(first_history, component_) = slope;
  derivatives.next_by_last(first_history, component_) = -slope;
  derivatives.next_by_history(first_history, first_history) = step.left;
  derivatives.next_by_parameter.row(first_history).segment<2>(first_parameter) = by_parameter;
}

}  // namespace pliant
