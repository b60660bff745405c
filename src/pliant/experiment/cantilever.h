#pragma once

#include "pliant/experiment/strip_profiles.h"

namespace pliant {

/// Strips that stick out of a clamp and bend under their own weight, at several overhangs (Clapp et
/// al. 1990).
class Cantilever : public StripProfiles {
 public:
  /// @param density  kg/m^2, > 0
  /// @throws InputError for an overhang that is not positive
  Cantilever(const ExperimentSpec& spec, double density);

 private:
  Cantilever(const ExperimentSpec& spec, double density, const DataRows& data);
};

}  // namespace pliant
