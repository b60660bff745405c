#pragma once

#include "pliant/base/errors.h"
#include "pliant/material/material.h"

namespace pliant {

/// Whether a component of a solid's material sees changes of shape alone.
bool is_isochoric(const std::string& component);

/// Whether a component with a law resists a change of volume.
bool resists_volume(const Material& material);

/// @param where  of what needs it, for the message
/// @throws InputError for cloth, and for a solid without any law
void require_solid_law(const Material& material, const Location& where);

/// @throws InputError for a solid that differs from place to place, which a piece does not
void require_same_everywhere(const Material& material, const Location& where);

/// A solid with a law, and that something resists a change of volume.
void require_solid_of_volume(const Material& material, const Location& where);

}  // namespace pliant
