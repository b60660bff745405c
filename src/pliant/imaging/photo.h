#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/imaging/picture_file.h"

namespace pliant {

/// Reads a photograph as brightness, turned as its camera held it.
/// @throws InputError for a file that is no picture
Photo read_photo(const std::filesystem::path& file);

/// A rectangle of a photograph, in pixels.
struct PixelRegion {
  int x = 0, y = 0;  ///< of its upper left pixel
  int width = 0, height = 0;
};

/// Reads a photograph, or a region of it, with its colours, turned as its camera held it.
/// @throws InputError for a file that is no picture, or a region that is not within it
ColourPhoto read_colours(const std::filesystem::path& file,
                         const std::optional<PixelRegion>& region);

/// @param columns, rows  of the whole picture
/// @throws InputError for a region that is not within it
void require_within(const PixelRegion& region, int columns, int rows, const Location& where);

/// The photograph with a line drawn on it, as the content of a PNG file.
/// @param line  in pixels (x to the right, y down), the centre of the first pixel being (0, 0)
/// @throws InputError for a file that is no picture
std::string photo_with_line(const std::filesystem::path& file,
                            const std::vector<Eigen::Vector2d>& line);

/// The photograph with a closed line drawn on it and a cross at a pixel, as the content of a PNG
/// file.
/// @throws InputError for a file that is no picture
std::string photo_with_outline(const std::filesystem::path& file,
                               const std::vector<Eigen::Vector2d>& outline,
                               const Eigen::Vector2d& cross);

/// What each pixel was taken for: a candidate could be what is looked for.
enum class Seen : unsigned char { background, standing_out, candidate };
using SeenPixels = Eigen::Array<Seen, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A photograph, paler, on which the part that was looked at is framed; in it what stands out is
/// blue, and orange what could be what is looked for. The content of a PNG file.
/// @param seen  of a part of the photograph
/// @param x, y  the upper left pixel of that part
/// @throws InputError for a file that is no picture
std::string photo_as_seen(const std::filesystem::path& file, const SeenPixels& seen, int x, int y);

}  // namespace pliant
