#include "pliant/material/density/linearized_dahl_friction.h"

#include <cmath>

namespace pliant {
namespace {

// The factor of (strain - last) in [T] Eq. 5.9; `increment` is the papers' rate times time step.
double slope(const DahlParameters& dahl, double last, double stress, double increment) {
  const double s = increment < 0 ? -1 : 1, side = last < 0 ? -1 : 1;
  return (max_friction_stress(dahl, last) - s * stress + side * dahl.b * increment) /
         (dahl.tau + s * increment);
}

}  // namespace

LinearizedDahlFriction::LinearizedDahlFriction(int component, const DahlBySide& dahl)
    : component_(component), dahl_(dahl) {}

void LinearizedDahlFriction::add(const Samples& samples, const StepTime&,
                                 Response& response) const {
  for (int i = 0; i < kLanes; ++i) {
    const double last = samples.last(i, component_), from = samples.history(i, 0);
    const double way = samples.strain(i, component_) - last;
    const double k = slope(dahl_.at(last), last, from, last - samples.before(i, component_));
    response.work(i) += from * way + k * way * way / 2;
    response.stress(i, component_) += from + k * way;
    response.tangent(i, component_ * samples.strain.cols() + component_) += k;
  }
}

void LinearizedDahlFriction::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                                     Lane& work) const {
  for (int i = 0; i < kLanes; ++i) {
    const FrictionState start{samples.last(i, component_), samples.history(i, 0)};
    work(i) += friction_work(dahl_, samples.strain(i, component_), start);
    next(i, 0) = friction_stress(dahl_, samples.strain(i, component_), start).friction.stress;
  }
}

}  // namespace pliant
