#pragma once

#include <Eigen/Core>

#include "pliant/io/fields.h"

namespace pliant {

/// [column, row] of a picture.
Eigen::Vector2d read_pixel(const Value& value);

/// `patch` and `step` of what is followed in pictures, where they are told.
/// @param patch  pixels of a patch's side, odd
/// @param step   pixels from patch to patch
void read_patches(Fields& fields, int& patch, int& step);

}  // namespace pliant
