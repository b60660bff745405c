#pragma once

#include "pliant/material/material.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Adds where a heterogeneous material has samples, and what they differ in.
void add_samples(const Material& material, FileInfo& info);

}  // namespace pliant
