#include "pliant/imaging/deep_picture.h"

#include <cstdint>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using Levels = Eigen::Array<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// 40 x 30 pixels, from 0 to a brightest one.
Levels ramp(int brightest) {
  Levels levels(30, 40);
  for (Eigen::Index i = 0; i < levels.size(); ++i) {
    levels.data()[i] = static_cast<std::uint16_t>(brightest * i / (levels.size() - 1));
  }
  return levels;
}

void write_png(const std::filesystem::path& file, const Levels& levels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(levels.cols());
  header.height = static_cast<png_uint_32>(levels.rows());
  header.format = PNG_FORMAT_LINEAR_Y;
  ASSERT_NE(png_image_write_to_file(&header, file.c_str(), 0, levels.data(), 0, nullptr), 0);
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
  Levels rows = levels;  // written in place
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    ASSERT_EQ(TIFFWriteScanline(tiff, rows.row(row).data(), static_cast<std::uint32_t>(row), 0), 1);
  }
  TIFFClose(tiff);
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
  for (const auto& [brightest, white] :
       {std::pair(1020, 1023), std::pair(1024, 4095), std::pair(4095, 4095),
        std::pair(16000, 16383), std::pair(65520, 65535)}) {
    const Levels levels = ramp(brightest);
    const Photo photo = read_photo(written(levels));
    ASSERT_EQ(photo.rows(), 30);
    ASSERT_EQ(photo.cols(), 40);
    const Photo expected = levels.cast<float>() / static_cast<float>(white);
    EXPECT_LT((photo - expected).abs().maxCoeff(), 1e-6) << brightest;
  }
}

TEST_P(DeepPicture, ThatIsCutIsRefused) {
  const auto file = written(ramp(4095));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const InputError error = test::input_error_of([&] { read_photo(file); });
  EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().file));
}

INSTANTIATE_TEST_SUITE_P(Files, DeepPicture,
                         testing::Values(Case{"a.png", write_png}, Case{"a.tiff", write_tiff}),
                         [](const auto& item) { return std::string(item.param.file, 2, 3); });

TEST(ShallowPicture, IsLeftToOthers) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "8.png";
  folder.write("8.png", png_of(ColourPhoto{2, 2, std::vector<unsigned char>(12, 255)}));
  EXPECT_FALSE(read_deep_picture(file));
  EXPECT_FALSE(read_deep_picture(folder.path() / "none.png"));
  EXPECT_EQ(read_photo(file)(1, 1), 1);
}

}  // namespace
}  // namespace pliant
