#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A photograph as brightness from 0 to 1; row 0 is the uppermost, column 0 the leftmost.
using Photo = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A photograph with its colours.
struct ColourPhoto {
  int rows = 0, columns = 0;
  std::vector<unsigned char> levels;  ///< blue, green and red of each pixel, row by row
};

/// Reads a photograph, turned as its camera held it; one of more bits a level as 8.
/// @throws InputError for a file that is no picture, or not a whole one
ColourPhoto read_picture(const std::filesystem::path& file);
/// The same of one that is not deep, as of `read_deep_picture`.
ColourPhoto read_shallow_picture(const std::filesystem::path& file);

/// The content of a PNG file.
std::string png_of(const ColourPhoto& picture);

}  // namespace pliant
