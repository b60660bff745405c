#pragma once

#include "pliant/experiment/profile/strip_profiles.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// Strips that were rolled around cylinders and released, hanging from a clamp by one end ([P]
/// 4.3). Each starts flat, is bent to the cylinder's curvature and let go little by little.
class RolledStrip : public StripProfiles {
 public:
  /// @throws InputError for a radius of zero, or profiles that are more curved than the cylinder
  RolledStrip(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
};

}  // namespace pliant
