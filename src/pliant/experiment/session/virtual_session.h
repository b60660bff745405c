#pragma once

#include <functional>
#include <string>

#include "pliant/base/progress.h"
#include "pliant/base/random.h"
#include "pliant/experiment/session/virtual/options.h"
#include "pliant/material/material.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// How the work of a session is followed.
struct SessionWork {
  std::string name = "session";  ///< for messages
  StopToken stop = {};
  std::function<void(int frames)> done = [](int) {};  ///< frames that have been found
};

/// Measures a sheet as the system of [T] 3.2 would: what holds it goes a prescribed way, and the
/// sheet follows along equilibria with the friction that the ones before have left.
/// @param material  with all components of a sheet, and a density
/// @return what instruments with the noise of `options` see
/// @throws SolverError where the sheet finds no equilibrium
Session make_virtual_session(const Material& material, const VirtualSession& options,
                             RandomStream& random, const SessionWork& work = {});

}  // namespace pliant
