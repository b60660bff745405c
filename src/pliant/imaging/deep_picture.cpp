#include "pliant/imaging/deep_picture.h"

#include <array>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <png.h>
#include <tiffio.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr int kBits = 16;

using Levels = Eigen::Array<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void refuse_damaged(const std::filesystem::path& file) {
  throw InputError({file.string()}, "ends too early or is damaged", "a whole picture");
}

/// @throws InputError for more pixels than a picture has
Levels levels_of(std::uint32_t rows, std::uint32_t columns, const std::filesystem::path& file) {
  constexpr double kMost = 250e6;
  if (static_cast<double>(rows) * columns > kMost) {
    throw InputError({file.string()}, fmt::format("says that it has {} x {} pixels", columns, rows),
                     "a picture of at most 250 million");
  }
  return {rows, columns};
}

/// The steps of libpng that may end in an error, which jumps over what C++ would clean up: each is
/// a function without anything of that kind.
class PngReader {
 public:
  explicit PngReader(std::FILE* file)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, warn)),
        info_(png_create_info_struct(png_)) {
    png_init_io(png_, file);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  /// @return false where that fails, as below
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }

  bool is_deep_grey() const {
    return png_get_bit_depth(png_, info_) == kBits &&
           png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY &&
           png_get_valid(png_, info_, PNG_INFO_tRNS) == 0;
  }
  std::uint32_t rows() const { return png_get_image_height(png_, info_); }
  std::uint32_t columns() const { return png_get_image_width(png_, info_); }

  /// @param rows  where each is to be put
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_interlace_handling(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    png_read_image(png_, rows);
    return true;
  }

 private:
  [[noreturn]] static void fail(png_structp png, png_const_charp /*why*/) { png_longjmp(png, 1); }
  static void warn(png_structp /*png*/, png_const_charp /*why*/) {}

  png_structp png_;
  png_infop info_;
};

std::optional<Levels> read_png(std::FILE* open, const std::filesystem::path& file) {
  PngReader reader(open);
  if (!reader.read_header()) refuse_damaged(file);
  if (!reader.is_deep_grey()) return std::nullopt;
  Levels levels = levels_of(reader.rows(), reader.columns(), file);
  std::vector<png_bytep> rows;
  for (auto row : levels.rowwise()) rows.push_back(reinterpret_cast<png_bytep>(row.data()));
  if (!reader.read_rows(rows.data())) refuse_damaged(file);
  return levels;
}

struct CloseTiff {
  void operator()(TIFF* file) const { TIFFClose(file); }
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

/// The library would print.
int say_nothing(TIFF* /*file*/, void* /*own*/, const char* /*where*/, const char* /*format*/,
                va_list /*arguments*/) {
  return 1;
}

/// Nothing where its directory cannot be read.
Tiff opened_tiff(const std::filesystem::path& file) {
  const std::unique_ptr<TIFFOpenOptions, CloseTiff> options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
  return Tiff(TIFFOpenExt(file.c_str(), "rm", options.get()));  // r: read, m: not mapped
}

template <class Number>
Number tag_of(TIFF* file, std::uint32_t tag) {
  Number value{};
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

/// Black at 0, in rows from the top.
bool is_deep_grey(TIFF* file) {
  const auto is = [&](std::uint32_t tag, int value) {
    return tag_of<std::uint16_t>(file, tag) == value;
  };
  return is(TIFFTAG_BITSPERSAMPLE, kBits) && is(TIFFTAG_SAMPLESPERPIXEL, 1) &&
         is(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT) &&
         is(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) &&
         is(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) && TIFFIsTiled(file) == 0;
}

std::optional<Levels> read_tiff(const std::filesystem::path& file) {
  const Tiff tiff = opened_tiff(file);
  if (!tiff || !is_deep_grey(tiff.get())) return std::nullopt;
  Levels levels = levels_of(tag_of<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH),
                            tag_of<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH), file);
  const tmsize_t row_bytes = levels.cols() * tmsize_t{sizeof(std::uint16_t)};
  if (levels.size() == 0 || TIFFScanlineSize(tiff.get()) != row_bytes) refuse_damaged(file);
  for (Eigen::Index row = 0; row < levels.rows(); ++row) {
    const auto number = static_cast<std::uint32_t>(row);
    if (TIFFReadScanline(tiff.get(), levels.row(row).data(), number) < 0) refuse_damaged(file);
  }
  return levels;
}

bool is_tiff(std::string_view start) {
  using std::string_view_literals::operator""sv;
  return start == "II*\0"sv || start == "MM\0*"sv || start == "II+\0"sv || start == "MM\0+"sv;
}

std::optional<Levels> read_levels(const std::filesystem::path& file) {
  const File open(std::fopen(file.c_str(), "rb"));
  if (!open) return std::nullopt;
  std::array<char, 8> start{};
  const std::size_t read = std::fread(start.data(), 1, start.size(), open.get());
  const auto* bytes = reinterpret_cast<png_const_bytep>(start.data());
  if (read == start.size() && png_sig_cmp(bytes, 0, start.size()) == 0) {
    std::rewind(open.get());
    return read_png(open.get(), file);
  }
  if (is_tiff({start.data(), 4})) return read_tiff(file);
  return std::nullopt;
}

}  // namespace

std::optional<Photo> read_deep_picture(const std::filesystem::path& file) {
  constexpr int kWhiteOfTwelve = 4095, kWhite = 65535;
  const std::optional<Levels> levels = read_levels(file);
  if (!levels) return std::nullopt;
  const int white = levels->maxCoeff() <= kWhiteOfTwelve ? kWhiteOfTwelve : kWhite;
  return levels->cast<float>() / static_cast<float>(white);
}

}  // namespace pliant
