#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"

namespace pliant {

/// A cord stays at one place of its clip within this part of the sample's longer side.
inline constexpr double kCordDrift = 0.05;

/// Sentences about cords that are not at their clip, that move about it, that are missing in some
/// frames or all, and that push clips together instead of pulling them apart.
std::vector<std::string> cord_warnings(const Session& session);

}  // namespace pliant
