#pragma once

#include "pliant/experiment/profile/strip_profiles.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// Strips that stick out of a clamp and bend under their own weight, at several overhangs (Clapp et
/// al. 1990).
class Cantilever : public StripProfiles {
 public:
  /// @throws InputError for an overhang that is not positive
  Cantilever(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
};

}  // namespace pliant
