#include "pliant/experiment/cantilever/cantilever.h"

#include <fmt/format.h>

#include "pliant/experiment/cantilever/cantilever_type.h"

namespace pliant {

Cantilever::Cantilever(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : StripProfiles(spec, data, cloth.density, "overhang") {
  if (!spec_of<CantileverSpec>(spec).density_is_known) estimate_density(cloth.density);
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
