#include "pliant/experiment/drape/drape_schedule.h"

#include <algorithm>
#include <vector>

#include "pliant/base/quantity.h"

namespace pliant {
namespace {

constexpr double kSinking = 0.05;      // m/s
constexpr double kBelowReach = 0.005;  // m
constexpr double kPause = 0.3;         // s, after the platform has left
constexpr double kPull = 0.5;          // s, of each way of the weight
constexpr double kPulledWeight = 2;    // of its own
constexpr double kSwing = 0.25;        // s, from one weight to the next

/// Weights that a shaken specimen swings between, of its own.
const std::vector<double> kShakenWeights{1.8, 0.2, 1.6, 0.4, 1.4, 0.6, 1.2, 0.8, 1.1, 0.9, 1};

/// A number that changes evenly between times.
struct Ramp {
  std::vector<double> times, values;

  void go_on(double seconds, double value) {
    times.push_back(times.back() + seconds);
    values.push_back(value);
  }
  double at(double time) const {
    if (time >= times.back()) return values.back();
    const auto next = std::ranges::upper_bound(times, time) - times.begin();
    if (next == 0) return values.front();
    const auto i = static_cast<std::size_t>(next);
    const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  }
};

Ramp weight_of(DrapeHistory history, double lowered) {
  Ramp weight{{0}, {1}};
  weight.go_on(lowered, 1);
  if (history == DrapeHistory::pulled) {
    weight.go_on(kPull, kPulledWeight);
    weight.go_on(kPull, 1);
  } else if (history == DrapeHistory::shaken) {
    for (const double next : kShakenWeights) weight.go_on(kSwing, next);
  }
  return weight;
}

}  // namespace

DrapeSchedule drape_schedule(const DrapeSetup& setup) {
  const double depth = setup.overhang() + kBelowReach, lowered = depth / kSinking + kPause;
  const Ramp weight = weight_of(setup.history, lowered);
  const auto controls = [=](double time) {
    Controls now;
    now.time = time;
    now.vectors.setZero(3, 2);
    now.vectors(2, kDrapeGravity) = -kStandardGravity * weight.at(time);
    now.vectors(2, kDrapePlatform) = -std::min(kSinking * time, depth);
    return now;
  };
  return {weight.times.back(), controls};
}

}  // namespace pliant
