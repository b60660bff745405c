#pragma once

#include <utility>

#include <Eigen/Core>

#include "pliant/io/fields.h"

namespace pliant {

/// `[x, y, z]`, bare numbers in SI.
/// @throws InputError
Eigen::Vector3d read_vector(const Value& value);

/// `100 mm x 50 mm`, both above 0, in metres.
/// @throws InputError
std::pair<double, double> read_extents(const Value& value);

/// `25x13`: two whole numbers in [low, high].
/// @throws InputError
std::pair<int, int> read_counts(const Value& value, int low, int high);

}  // namespace pliant
