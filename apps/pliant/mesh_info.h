#pragma once

#include <filesystem>

#include "apps/pliant/file_info.h"

namespace pliant {

/// Describes a mesh file (.obj, .ply) in its own unit, which it does not tell, and checks whether
/// it is fit for simulation; what is wrong becomes warnings.
/// @throws InputError where the file cannot be read or its faces cannot be cut into triangles
FileInfo mesh_info(const std::filesystem::path& path);

}  // namespace pliant
