#pragma once

#include <filesystem>
#include <string>

#include "pliant/geometry/volume_source.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Describes the file of a volume mesh (.msh, .mesh) in its own unit, which it does not tell, and
/// checks whether it is fit for simulation; what is wrong becomes warnings.
/// @throws InputError where the file cannot be read
FileInfo volume_info(const std::filesystem::path& path);

/// How a body comes by its mesh, in words.
std::string text_of(const VolumeSource& source);

}  // namespace pliant
