#pragma once

#include <cstdint>

#include "pliant/base/journal.h"
#include "pliant/base/progress.h"

namespace pliant {

/// What a run brings to every long computation.
struct RunContext {
  Progress& progress = silent_progress();
  StopToken stop;
  int threads = 1;
  std::uint64_t seed = 0;
  Journal& journal = forgetful_journal();
};

}  // namespace pliant
