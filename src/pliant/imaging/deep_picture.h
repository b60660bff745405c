#pragma once

#include <filesystem>
#include <optional>

#include "pliant/imaging/picture_file.h"

namespace pliant {

/// Reads a grey picture of 16 bits a level, as cameras for measurement write them, as brightness
/// from 0 to 1: PNG without transparency, whatever gamma it states, or TIFF, black at 0, in rows
/// from the top.
///
/// Cameras of 10 and 12 bits store numbers up to 4095: that is white where no pixel is brighter,
/// and else 65535.
/// @return nothing for any other picture
/// @throws InputError for a file that is damaged, or of more than 250 million pixels
std::optional<Photo> read_deep_picture(const std::filesystem::path& file);

}  // namespace pliant
