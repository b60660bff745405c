#include "pliant/experiment/rolled/rolled_strip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/profile/profile_curvature.h"

namespace pliant {
namespace {

// Nothing hangs on the free end: what it kept of its curvature is less than the cylinder's.
void require_less_curved(const ProfileRows& profile, double length, const DataRows& data) {
  constexpr double kMost = 1.3;  // noise, and what little weight there is
  constexpr size_t kEnd = 2;     // the last of that many parts
  const std::vector<double> curvature = profile_curvature(profile, length);
  const size_t count = std::max<size_t>(curvature.size() / kEnd, 2);
  const double mean =
      std::accumulate(curvature.end() - static_cast<std::ptrdiff_t>(count), curvature.end(), 0.0) /
      static_cast<double>(count);
  if (mean * profile.setting < kMost) return;
  throw InputError(
      data.location(profile.first, "radius"),
      fmt::format("is {}, but the free end kept a radius of {}",
                  millimetres(std::abs(profile.setting)), millimetres(std::abs(1 / mean))),
      "the radius of the cylinder: a released strip is less curved");
}

}  // namespace

RolledStrip::RolledStrip(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : StripProfiles(spec, data, cloth.density, "radius") {
  for (const ProfileRows& profile : profiles()) {
    if (profile.setting == 0) {
      throw InputError(data.location(profile.first, "radius"), "is zero",
                       "the radius of the cylinder; negative where it turns the strip right");
    }
    require_less_curved(profile, spec.test->length, data);
    add_strip(profile, spec.test->length, 1 / profile.setting, data);
  }
  info_.handled.push_back(
      fmt::format("{} profiles: each strip starts flat, is bent to its cylinder and released",
                  profiles().size()));
}

}  // namespace pliant
