#pragma once

#include <string>

#include "pliant/experiment/press/pressed_body.h"
#include "pliant/io/fields.h"

namespace pliant {

/// Reads `fixed`, `direction`, `radius` and `through` of a body whose mesh is known.
///
/// `fixed` names a node group or a region of the mesh, or a side of the body: -x, +x, -y, +y, -z or
/// +z. `direction` is one of these, or a vector.
/// @param fixed  gets what is held, as it is written
/// @throws InputError, also for an indenter that passes beside the body
void read_press_setup(Fields& fields, PressSetup& setup, std::string& fixed);

}  // namespace pliant
