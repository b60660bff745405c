#pragma once

#include <vector>

#include "pliant/base/progress.h"
#include "pliant/mechanics/parameters.h"

namespace pliant {

/// With what a body goes along its rows.
struct BodyPathOptions {
  Parameters parameters = {};  ///< of the body's system
  std::vector<int> by = {};    ///< of them, those that derivatives are wanted by
  StopToken stop = {};
};

}  // namespace pliant
