#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/density/density.h"

namespace pliant {

/// The parameters of all materials of a system, with the values of these materials.
struct ParameterList {
  std::vector<std::string> names;
  std::vector<double> values;
};

/// The laws of a system's potentials with other values of its parameters; `System::with` makes
/// them. Constant, and shared by as many threads as like.
struct Parameters {
  /// One a potential, in their order; null, or none at all, for the law that it was built with.
  std::vector<std::shared_ptr<const ParametricDensity>> laws;

  const ParametricDensity* law(size_t potential) const {
    return potential < laws.size() ? laws[potential].get() : nullptr;
  }
};

inline const Parameters kAsBuilt{};

}  // namespace pliant
