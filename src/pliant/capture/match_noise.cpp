#include "pliant/capture/match_noise.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/capture/median.h"

namespace pliant {

void MatchNoise::add(const PatchTracker& tracker) {
  std::vector<double> deviations;
  for (const TrackedPatch& patch : tracker.patches()) {
    if (patch.is_seen) deviations.push_back(patch.noise());
  }
  if (!deviations.empty()) medians_.push_back(median(std::move(deviations)));
}

std::string MatchNoise::doubt() const {
  // By its gradients, a print of `pliant pattern cloth` under noise of 1 % of white leaves squares
  // of 21 pixels 0.011 to 0.013 through a lens that blurs by 0.7 pixels, 0.025 to 0.031 by 2, 0.042
  // to 0.057 by 3.
  constexpr double kMost = 0.03;
  const double deviation = median(medians_);
  if (deviation <= kMost) return {};
  return fmt::format(
      "leaves squares uncertain by {:.2g} pixels (standard deviation, median), where an irregular "
      "print of 3 to 5 pixels in focus leaves 0.01: it is blurred or noisy, or the texture is "
      "coarse or pale",
      deviation);
}

}  // namespace pliant
