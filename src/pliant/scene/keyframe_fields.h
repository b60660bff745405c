#pragma once

#include "pliant/io/fields.h"
#include "pliant/scene/keyframes.h"
#include "pliant/scene/motion.h"

namespace pliant {

/// `{pivot, interpolation, keyframes: [{time, translate, rotate}]}`.
/// @throws InputError, also for keyframes out of order
Motion read_motion(const Value& value);

/// A vector that stays as it is, or `{interpolation, keyframes: [{time, value}]}`.
/// @throws InputError, also for keyframes out of order
KeyframedVector read_keyframed_vector(const Value& value);

}  // namespace pliant
