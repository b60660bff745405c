#pragma once

#include <cmath>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/material/density/density.h"

namespace pliant::test {

/// Eight material points with storage of their own; one row a point.
struct LaneState {
  using Numbers = Eigen::Array<double, kLanes, Eigen::Dynamic>;
  Numbers strain, last, before, history;
  Numbers weights = Numbers(kLanes, 0);  ///< of material samples

  LaneState(int strains, int history_size)
      : strain(kLanes, strains), last(kLanes, strains), before(kLanes, strains) {
    strain.setZero();
    last.setZero();
    before.setZero();
    history.setZero(kLanes, history_size);
  }

  static LaneView view(const Numbers& numbers) {
    return LaneView(numbers.data(), kLanes, numbers.cols());
  }
  Samples samples() const {
    return {view(strain), view(last), view(before), view(history), view(weights)};
  }
};

inline Response response_of(const Density& density, const LaneState& state,
                            const StepTime& time = {}) {
  Response response(static_cast<int>(state.strain.cols()));
  density.add(state.samples(), time, response);
  return response;
}

/// Ends a step: `state` then is at rest at its strain.
/// @return the work of each point
inline Lane advance(const Density& density, LaneState& state, const StepTime& time = {}) {
  Eigen::Array<double, kLanes, Eigen::Dynamic> next(kLanes, state.history.cols());
  next.setZero();
  Lane work = Lane::Zero();
  density.advance(state.samples(), time, MutableLaneView(next.data(), kLanes, next.cols()), work);
  state.history = next;
  state.before = state.last;
  state.last = state.strain;
  return work;
}

/// Uniform in +-`reach`, at least `gap` from every number of `kinks`.
inline double away_from(RandomStream& random, double reach, double gap,
                        const std::vector<double>& kinks) {
  for (;;) {
    const double x = random.uniform(-reach, reach);
    bool away = true;
    for (const double kink : kinks) away = away && std::abs(x - kink) > gap;
    if (away) return x;
  }
}

}  // namespace pliant::test
