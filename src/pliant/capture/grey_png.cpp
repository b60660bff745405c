#include "pliant/capture/grey_png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <png.h>
#include <zlib.h>

#include "pliant/base/assert.h"
#include "pliant/io/byte_order.h"

namespace pliant {
namespace {

/// The chunk that tells the resolution, which libpng's simple interface does not write.
std::string resolution_chunk(double pixels_per_metre) {
  constexpr std::uint8_t kPerMetre = 1;
  const auto resolution = static_cast<std::uint32_t>(std::lround(pixels_per_metre));
  std::string body = "pHYs";
  append_number(resolution, ByteOrder::big, body);
  append_number(resolution, ByteOrder::big, body);
  append_number(kPerMetre, ByteOrder::big, body);
  const auto check = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  std::string chunk;
  append_number(static_cast<std::uint32_t>(body.size() - 4), ByteOrder::big, chunk);
  chunk += body;
  append_number(check, ByteOrder::big, chunk);
  return chunk;
}

/// @param format  of libpng
/// @param levels  row by row from the upper left pixel
std::string png_bytes(png_uint_32 format, const void* levels, Eigen::Index columns,
                      Eigen::Index rows, double pixels_per_metre) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(columns);
  header.height = static_cast<png_uint_32>(rows);
  header.format = format;

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  const int written =
      png_image_write_to_memory(&header, bytes.data(), &size, 0, levels, 0, nullptr);
  PLIANT_ASSERT(written != 0, std::string("libpng: ") + header.message);
  bytes.resize(size);
  constexpr std::size_t kAfterHeader = 8 + 25;  // signature and the chunk IHDR
  bytes.insert(kAfterHeader, resolution_chunk(pixels_per_metre));
  return bytes;
}

/// Row by row.
template <class Level>
std::vector<Level> levels_of(const GreyPicture& picture) {
  constexpr auto kWhite = static_cast<float>(std::numeric_limits<Level>::max());
  std::vector<Level> levels;
  levels.reserve(static_cast<std::size_t>(picture.size()));
  for (const float value : picture.reshaped<Eigen::RowMajor>()) {
    levels.push_back(static_cast<Level>(std::lround(kWhite * std::clamp(value, 0.0F, 1.0F))));
  }
  return levels;
}

}  // namespace

std::string grey_png_bytes(std::span<const std::uint8_t> levels, int columns, int rows,
                           double pixels_per_metre) {
  PLIANT_ASSERT(levels.size() == static_cast<std::size_t>(columns) * rows, "a level a pixel");
  return png_bytes(PNG_FORMAT_GRAY, levels.data(), columns, rows, pixels_per_metre);
}

std::string grey_png_bytes(const GreyPicture& picture, double pixels_per_metre) {
  return png_bytes(PNG_FORMAT_GRAY, levels_of<std::uint8_t>(picture).data(), picture.cols(),
                   picture.rows(), pixels_per_metre);
}

std::string deep_grey_png_bytes(const GreyPicture& picture, double pixels_per_metre) {
  return png_bytes(PNG_FORMAT_LINEAR_Y, levels_of<std::uint16_t>(picture).data(), picture.cols(),
                   picture.rows(), pixels_per_metre);
}

}  // namespace pliant
