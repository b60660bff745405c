#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A photograph as brightness from 0 to 1; row 0 is the uppermost, column 0 the leftmost.
using Photo = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Reads a photograph as brightness, turned as its camera held it.
/// @throws InputError for a file that is no picture
Photo read_photo(const std::filesystem::path& file);

/// The photograph with a line drawn on it, as the content of a PNG file.
/// @param line  in pixels (x to the right, y down), the centre of the first pixel being (0, 0)
/// @throws InputError for a file that is no picture
std::string photo_with_line(const std::filesystem::path& file,
                            const std::vector<Eigen::Vector2d>& line);

/// What each pixel was taken for.
enum class Seen : unsigned char { background, standing_out, long_and_thin };
using SeenPixels = Eigen::Array<Seen, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A photograph, paler, on which the part that was looked at is framed; in it what stands out is
/// blue, and orange what is long and thin as well. The content of a PNG file.
/// @param seen  of a part of the photograph
/// @param x, y  the upper left pixel of that part
/// @throws InputError for a file that is no picture
std::string photo_as_seen(const std::filesystem::path& file, const SeenPixels& seen, int x, int y);

}  // namespace pliant
