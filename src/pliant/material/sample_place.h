#pragma once

#include <Eigen/Core>

#include "pliant/io/fields.h"
#include "pliant/material/material.h"

namespace pliant {

/// Where a sample of a material lies: [x, y, z] in a body at rest, [u, v] in the rest plane of a
/// sheet (m), whose third coordinate is 0.
/// @throws InputError
Eigen::Vector3d read_sample_place(const Value& value, MaterialKind kind);

}  // namespace pliant
