#pragma once

#include "pliant/io/fields.h"
#include "pliant/scene/motion.h"

namespace pliant {

/// `{axis: [x, y, z], angle: 30 deg}` or `{quaternion: [w, x, y, z]}`; neither needs unit length.
/// @throws InputError
Rotation read_rotation(const Value& value);

}  // namespace pliant
