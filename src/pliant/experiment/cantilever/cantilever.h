#pragma once

#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/profile/strip_profiles.h"

namespace pliant {

/// Strips that stick out of a clamp and bend under their own weight, at several overhangs (Clapp et
/// al. 1990).
class Cantilever : public StripProfiles {
 public:
  /// @param density  kg/m^2, > 0
  /// @throws InputError for an overhang that is not positive
  Cantilever(const ExperimentSpec& spec, const DataRows& data, double density);
};

}  // namespace pliant
