#pragma once

#include <filesystem>
#include <optional>

#include "pliant/imaging/photo.h"

namespace pliant {

/// Reads a grey picture of more than 8 bits a level, PNG or TIFF, as cameras for measurement write
/// them, as brightness from 0 to 1.
///
/// Cameras store 10, 12 or 14 bits as numbers of 16: white is the largest number of the fewest of
/// these bits that hold the brightest pixel.
/// @return nothing for any other picture
/// @throws InputError for a file that ends too early
std::optional<Photo> read_deep_picture(const std::filesystem::path& file);

}  // namespace pliant
