#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/document.h"
#include "pliant/material/material.h"

namespace pliant {

/// Reads a material from a material/1 file.
/// @throws InputError that names file, line and field of what is wrong
Material read_material(const std::filesystem::path& path);

/// The material that a document describes.
Material material_of(const Document& document);

/// The text of a material/1 file, SI units, numbers that read back to the same bits.
std::string material_text(const Material& material);

}  // namespace pliant
