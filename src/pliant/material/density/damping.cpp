#include "pliant/material/density/damping.h"

namespace pliant {

Damping::Damping(int component, double coefficient)
    : component_(component), coefficient_(coefficient) {}

Lane Damping::way(const Samples& samples, const StepTime& time) const {
  return samples.strain.col(component_) - time.now * samples.last.col(component_) -
         time.earlier * samples.before.col(component_);
}

void Damping::add(const Samples& samples, const StepTime& time, Response& response) const {
  const Lane way = this->way(samples, time);
  const double slope = coefficient_ * time.per_second;
  response.work += slope / 2 * way.square();
  response.stress.col(component_) += slope * way;
  response.tangent.col(component_ * samples.strain.cols() + component_) += slope;
}

// Stress at the end of the step times the step's strain.
void Damping::advance(const Samples& samples, const StepTime& time, MutableLaneView,
                      Lane& work) const {
  const Lane strain = samples.strain.col(component_) - samples.last.col(component_);
  work += coefficient_ * time.per_second * way(samples, time) * strain;
}

}  // namespace pliant
