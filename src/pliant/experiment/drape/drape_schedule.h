#pragma once

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/mechanics/controls.h"

namespace pliant {

/// What a specimen feels on its way: the vectors of the controls by their numbers.
enum DrapeControl : int { kDrapeGravity = 0, kDrapePlatform = 1 };

/// The way of a history.
struct DrapeSchedule {
  double duration = 0;  ///< s; from then on all stays as it is
  Schedule controls;    ///< of times from 0
};

/// The platform sinks by 5 cm a second until it is below all that the specimen can reach.
DrapeSchedule drape_schedule(const DrapeSetup& setup);

}  // namespace pliant
