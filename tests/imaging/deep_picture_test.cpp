#include "pliant/imaging/deep_picture.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <zlib.h>

#include "pliant/imaging/photo.h"
#include "pliant/io/byte_order.h"
#include "pliant/io/text_file.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Levels = Eigen::Array<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// 40 x 30 pixels, from 0 to a brightest one.
Levels ramp(int brightest) {
  Levels levels(30, 40);
  for (Eigen::Index i = 0; i < levels.size(); ++i) {
    levels.data()[i] = static_cast<std::uint16_t>(brightest * i / (levels.size() - 1));
  }
  return levels;
}

/// @param format  of libpng; of several channels a row of levels has the more of them
void write_png(const std::filesystem::path& file, const Levels& levels, png_uint_32 format) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(levels.cols()) / PNG_IMAGE_SAMPLE_CHANNELS(format);
  header.height = static_cast<png_uint_32>(levels.rows());
  header.format = format;
  ASSERT_NE(png_image_write_to_file(&header, file.c_str(), 0, levels.data(), 0, nullptr), 0);
}

void write_png(const std::filesystem::path& file, const Levels& levels) {
  write_png(file, levels, PNG_FORMAT_LINEAR_Y);
}

void write_tiff(const std::filesystem::path& file, const Levels& levels) {
  TIFF* tiff = TIFFOpen(file.c_str(), "wb");  // b: big-endian
  ASSERT_NE(tiff, nullptr);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(levels.cols()));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(levels.rows()));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 7);
  Levels rows = levels;  // written in place
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    ASSERT_EQ(TIFFWriteScanline(tiff, rows.row(row).data(), static_cast<std::uint32_t>(row), 0), 1);
  }
  TIFFClose(tiff);
}

/// Puts bytes in the place of others.
void overwrite(const std::filesystem::path& file, std::size_t at, const std::string& bytes) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(static_cast<std::streamoff>(at));
  stream.write(bytes.data(), std::ssize(bytes));
}

/// Changes the first numbers of a chunk of a PNG file, and the check behind them.
void change_chunk(const std::filesystem::path& file, const std::string& name,
                  const std::vector<std::uint32_t>& numbers) {
  const std::string bytes = read_text_file(file);
  const std::size_t at = bytes.find(name);
  ASSERT_NE(at, std::string::npos);
  const auto size = static_cast<unsigned char>(bytes[at - 1]);
  std::string chunk = name;
  for (const std::uint32_t number : numbers) append_number(number, ByteOrder::big, chunk);
  chunk += bytes.substr(at + chunk.size(), name.size() + size - chunk.size());
  const auto check = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size())));
  append_number(check, ByteOrder::big, chunk);
  overwrite(file, at, chunk);
}

struct Case {
  const char* file;
  void (*write)(const std::filesystem::path&, const Levels&);
};

class DeepPicture : public testing::TestWithParam<Case> {
 protected:
  std::filesystem::path written(const Levels& levels) const {
    const auto file = folder_.path() / GetParam().file;
    GetParam().write(file, levels);
    return file;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_P(DeepPicture, KeepsEachLevel) {
  for (const auto& [brightest, white] : {std::pair(1020, 4095), std::pair(4095, 4095),
                                         std::pair(4096, 65535), std::pair(65520, 65535)}) {
    const Levels levels = ramp(brightest);
    const Photo photo = read_photo(written(levels));
    ASSERT_EQ(photo.rows(), 30);
    ASSERT_EQ(photo.cols(), 40);
    const Photo expected = levels.cast<float>() / static_cast<float>(white);
    EXPECT_LT((photo - expected).abs().maxCoeff(), 1e-6) << brightest;
  }
}

// As reports draw upon it.
TEST_P(DeepPicture, HasColoursAsBright) {
  const ColourPhoto colours = read_picture(written(ramp(4095)));
  ASSERT_EQ(colours.levels.size(), 3U * 30 * 40);
  EXPECT_EQ(colours.levels.front(), 0);
  EXPECT_EQ(colours.levels.back(), 255);
  EXPECT_EQ(colours.levels[3 * 600], 128);
}

TEST_P(DeepPicture, ThatIsDamagedIsRefused) {
  const auto file = written(ramp(4095));
  overwrite(file, std::filesystem::file_size(file) / 3, std::string(100, '\xff'));
  const InputError error = test::input_error_of([&] { read_photo(file); });
  EXPECT_THAT(error.what(), AllOf(HasSubstr(GetParam().file), HasSubstr("damaged")));
}

INSTANTIATE_TEST_SUITE_P(Files, DeepPicture,
                         testing::Values(Case{"a.png", write_png}, Case{"a.tiff", write_tiff}),
                         [](const auto& item) { return std::string(item.param.file, 2, 3); });

class DeepPng : public testing::Test {
 protected:
  DeepPng() { write_png(file_, ramp(4095)); }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "a.png";
};

TEST_F(DeepPng, KeepsItsLevelsWhateverGammaItStates) {
  const Photo linear = read_photo(file_);
  change_chunk(file_, "gAMA", {45455});
  EXPECT_EQ((read_photo(file_) - linear).abs().maxCoeff(), 0);
}

TEST_F(DeepPng, ThatIsCutIsRefused) {
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(test::input_error_of([&] { read_photo(file_); }).what(), HasSubstr("ends too early"));
}

TEST_F(DeepPng, OfAnAbsurdSizeIsRefused) {
  change_chunk(file_, "IHDR", {1000000, 1000000});
  EXPECT_THAT(test::input_error_of([&] { read_photo(file_); }).what(),
              HasSubstr("1000000 x 1000000 pixels"));
}

TEST(OtherPicture, IsLeftToOthers) {
  const test::TemporaryFolder folder;
  const auto shallow = folder.path() / "8.png", coloured = folder.path() / "colours.png";
  folder.write("8.png", png_of(ColourPhoto{2, 2, std::vector<unsigned char>(12, 255)}));
  write_png(coloured, ramp(65535), PNG_FORMAT_LINEAR_RGB);
  EXPECT_FALSE(read_deep_picture(shallow));
  EXPECT_FALSE(read_deep_picture(coloured));
  EXPECT_FALSE(read_deep_picture(folder.path() / "none.png"));
  EXPECT_EQ(read_photo(shallow)(1, 1), 1);
  EXPECT_EQ(read_photo(coloured).cols(), 13);
}

}  // namespace
}  // namespace pliant
