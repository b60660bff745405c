#include "pliant/experiment/rolled/rolled_strip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/profile/profile_curvature.h"
#include "pliant/experiment/strip_figures.h"

namespace pliant {
namespace {

// Curvature that the free half kept (1/m): nothing hangs on it.
double kept_curvature(const ProfileRows& profile, double length) {
  constexpr size_t kEnd = 2;  // the last of that many parts
  const std::vector<double> curvature = profile_curvature(profile, length);
  const size_t count = std::max<size_t>(curvature.size() / kEnd, 2);
  return std::accumulate(curvature.end() - static_cast<std::ptrdiff_t>(count), curvature.end(),
                         0.0) /
         static_cast<double>(count);
}

// What the free end kept of its curvature is less than the cylinder's.
void require_less_curved(const ProfileRows& profile, double length, const DataRows& data) {
  constexpr double kMost = 1.3;  // noise, and what little weight there is
  const double mean = kept_curvature(profile, length);
  if (mean * profile.setting < kMost) return;
  throw InputError(
      data.location(profile.first, "radius"),
      fmt::format("is {}, but the free end kept a radius of {}",
                  millimetres(std::abs(profile.setting)), millimetres(std::abs(1 / mean))),
      "the radius of the cylinder: a released strip is less curved");
}

/// A share of the cylinder's curvature, the other way.
std::optional<std::string> turn_question(const std::vector<ProfileRows>& profiles, double length) {
  constexpr double kTurned = -0.2;
  for (const ProfileRows& profile : profiles) {
    if (kept_curvature(profile, length) * profile.setting > kTurned) continue;
    return fmt::format(
        "a strip of the radius {} winds the other way: is `y` counted downwards, as in pictures, "
        "or has `radius` the wrong sign?",
        millimetres(profile.setting));
  }
  return std::nullopt;
}

std::vector<std::string> questions_of(const std::vector<ProfileRows>& profiles,
                                      const ExperimentSpec& spec, const DataRows& data,
                                      double density) {
  StripFigures strip(*spec.test, density);
  const auto radius = strip.column("radius", Dimension::length, data.quantity_unit("radius"));
  for (const ProfileRows& profile : profiles) {
    strip.add(figures::kRadius, std::abs(profile.setting), {{radius}});
  }
  return first_asked({turn_question(profiles, spec.test->length), strip.question()});
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
  info_.questions = questions_of(profiles(), spec, data, cloth.density);
}

}  // namespace pliant
