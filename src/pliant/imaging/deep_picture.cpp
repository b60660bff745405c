#include "pliant/imaging/deep_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>

#include <png.h>
#include <tiffio.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr int kBits = 16;

using Levels = Eigen::Array<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

[[noreturn]] void refuse_cut(const std::filesystem::path& file) {
  throw InputError({file.string()}, "ends too early or is damaged", "a whole picture");
}

/// The largest number of the fewest bits that hold all levels.
double white_of(const Levels& levels) {
  for (const int bits : {10, 12, 14}) {
    const int largest = (1 << bits) - 1;
    if (levels.maxCoeff() <= largest) return largest;
  }
  return (1 << kBits) - 1;
}

bool is_deep_png(const std::filesystem::path& file) {
  constexpr std::size_t kDepthAt = 24, kRead = 25;  // behind the signature and the size
  std::array<unsigned char, kRead> start{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(start.data()), kRead);
  return stream && png_sig_cmp(start.data(), 0, 8) == 0 && start[kDepthAt] == kBits;
}

Levels read_png(const std::filesystem::path& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, file.c_str()) == 0) refuse_cut(file);
  header.format = PNG_FORMAT_LINEAR_Y;
  Levels levels(header.height, header.width);
  const int read = png_image_finish_read(&header, nullptr, levels.data(), 0, nullptr);
  if (read == 0) refuse_cut(file);
  return levels;
}

struct CloseTiff {
  void operator()(TIFF* file) const { TIFFClose(file); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

/// Nothing where it is no TIFF file.
Tiff opened_tiff(const std::filesystem::path& file) {
  TIFFSetErrorHandler(nullptr);  // which would print
  TIFFSetWarningHandler(nullptr);
  return Tiff(TIFFOpen(file.c_str(), "rm"));  // r: read, m: not mapped into memory
}

template <class Number>
Number tag_of(TIFF* file, std::uint32_t tag) {
  Number value{};
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

/// Grey rows of 16 bits, from the top down.
bool is_deep_grey(TIFF* file) {
  const auto is = [&](std::uint32_t tag, int value) {
    return tag_of<std::uint16_t>(file, tag) == value;
  };
  return is(TIFFTAG_BITSPERSAMPLE, kBits) && is(TIFFTAG_SAMPLESPERPIXEL, 1) &&
         is(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT) &&
         is(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) &&
         is(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) && TIFFIsTiled(file) == 0;
}

Levels read_tiff(TIFF* file, const std::filesystem::path& name) {
  Levels levels(tag_of<std::uint32_t>(file, TIFFTAG_IMAGELENGTH),
                tag_of<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH));
  const tmsize_t row_bytes = levels.cols() * tmsize_t{sizeof(std::uint16_t)};
  if (levels.size() == 0 || TIFFScanlineSize(file) != row_bytes) refuse_cut(name);
  for (Eigen::Index row = 0; row < levels.rows(); ++row) {
    const int read =
        TIFFReadScanline(file, levels.row(row).data(), static_cast<std::uint32_t>(row));
    if (read < 0) refuse_cut(name);
  }
  return levels;
}

std::optional<Levels> read_levels(const std::filesystem::path& file) {
  if (is_deep_png(file)) return read_png(file);
  const Tiff tiff = opened_tiff(file);
  if (tiff && is_deep_grey(tiff.get())) return read_tiff(tiff.get(), file);
  return std::nullopt;
}

}  // namespace

std::optional<Photo> read_deep_picture(const std::filesystem::path& file) {
  const std::optional<Levels> levels = read_levels(file);
  if (!levels) return std::nullopt;
  return levels->cast<float>() / static_cast<float>(white_of(*levels));
}

}  // namespace pliant
