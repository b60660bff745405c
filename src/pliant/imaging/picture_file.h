#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// A photograph with its colours.
struct ColourPhoto {
  int rows = 0, columns = 0;
  std::vector<unsigned char> levels;  ///< blue, green and red of each pixel, row by row
};

/// Reads a photograph, turned as its camera held it.
/// @throws InputError for a file that is no picture
ColourPhoto read_picture(const std::filesystem::path& file);

/// The content of a PNG file.
std::string png_of(const ColourPhoto& picture);

}  // namespace pliant
