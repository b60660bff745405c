#pragma once

#include <span>
#include <string>

#include "pliant/base/errors.h"
#include "pliant/material/material.h"

namespace pliant {

/// @param names  the components that are looked at, where they are known
/// @param where  of the material, for the message
/// @throws InputError that names a component whose stiffness is not positive at every strain that
///         it is meant for, and the strain: an affine stiffness that falls is meant for its range
///         alone, so that it needs one
void require_positive_stiffness(const Material& material, std::span<const std::string> names,
                                const Location& where = {});

/// A material whose affine stiffnesses that fall with strain end with their range and are constant
/// beyond it, as Hermite curves are: a simulation goes further than the measurements did, where
/// such a stiffness would turn negative and its energy would have no lower bound.
Material held_beyond_range(const Material& material);

}  // namespace pliant
