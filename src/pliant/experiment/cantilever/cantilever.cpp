#include "pliant/experiment/cantilever/cantilever.h"

#include <fmt/format.h>

namespace pliant {

Cantilever::Cantilever(const ExperimentSpec& spec, const DataRows& data, double density)
    : StripProfiles(spec, data, density, "overhang") {
  for (const ProfileRows& profile : profiles()) {
    if (!(profile.setting > 0)) {
      throw InputError(data.location(profile.first, "overhang"), "is not positive",
                       "the length that sticks out of the clamp");
    }
    add_strip(profile, profile.setting, 0, data);
  }
  info_.handled.push_back(fmt::format(
      "{} profiles: each strip starts flat and bends under its weight once", profiles().size()));
}

}  // namespace pliant
