#pragma once

#include "pliant/material/material.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Adds the limits of a material's energies, and at which strains those of one component are
/// reached.
void add_limits(const Material& material, FileInfo& info);

}  // namespace pliant
