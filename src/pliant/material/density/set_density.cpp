#include "pliant/material/density/set_density.h"

#include "pliant/base/assert.h"

namespace pliant {

/// The largest strains to either side, that at the end of a step included, and the strain from
/// rest.
struct SetDensity::Reach {
  Lane above, below, elastic;

  Reach(const Samples& samples, int component)
      : above(samples.history.col(0).max(samples.strain.col(component))),
        below(samples.history.col(1).min(samples.strain.col(component))) {
    const Lane strain = samples.strain.col(component);
    // Without rounding where the rest goes along: the slope is zero there.
    elastic = (strain == below).select(-above, strain - above - below);
  }
};

SetDensity::SetDensity(int component, double stiffness)
    : component_(component), stiffness_(stiffness) {
  PLIANT_ASSERT(stiffness >= 0, "elasticity pulls back");
}

// The integral of the stress over what moves the rest.
Lane SetDensity::lost(const Samples& samples, const Reach& now) const {
  const Lane above = samples.history.col(0), below = samples.history.col(1);
  return -stiffness_ * (below * (now.above - above) + above * (now.below - below));
}

void SetDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  const Reach now(samples, component_);
  const auto moves = now.above > samples.history.col(0) || now.below < samples.history.col(1);
  response.stored += stiffness_ / 2 * now.elastic.square();
  response.work += lost(samples, now);
  response.stress.col(component_) += stiffness_ * now.elastic;
  response.tangent.col(component_ * samples.strain.cols() + component_) +=
      moves.select(Lane::Zero(), Lane::Constant(stiffness_));
}

void SetDensity::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                         Lane& work) const {
  const Reach now(samples, component_);
  work += lost(samples, now);
  next.col(0) = now.above;
  next.col(1) = now.below;
}

std::unique_ptr<ParametricDensity> SetDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<SetDensity>(component_, values(0));
}

void SetDensity::differentiate(const Samples& samples, const StepTime&, int lane, int first_history,
                               int first_parameter, SampleDerivatives& derivatives) const {
  const Reach now(samples, component_);
  derivatives.stress_by_parameter(component_, first_parameter) += now.elastic(lane);
  const bool moves[] = {now.above(lane) > samples.history(lane, 0),
                        now.below(lane) < samples.history(lane, 1)};
  for (int side = 0; side < 2; ++side) {
    const int own = first_history + side;
    if (!moves[side]) derivatives.stress_by_history(component_, own) -= stiffness_;
    derivatives.next_by_strain(own, component_) = moves[side] ? 1 : 0;
    derivatives.next_by_history(own, own) = moves[side] ? 0 : 1;
  }
}

}  // namespace pliant
