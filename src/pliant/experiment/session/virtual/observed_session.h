#pragma once

#include "pliant/base/random.h"
#include "pliant/experiment/session/virtual/options.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// Makes of the true state of a session what the instruments of [T] 3.2.3 see.
///
/// Vertices, and the points where cords are attached, get white noise; poses of clips are the rigid
/// motions that fit theirs best. Cords drag over pulleys (`cord_drags`): their load cells show half
/// of the friction more while they pull their clip along, and half of it less while they give way.
/// @param session  true; its sheet starts at rest
void observe(const SessionNoise& noise, RandomStream& random, Session& session);

}  // namespace pliant
