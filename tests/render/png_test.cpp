#include "pliant/render/png.h"

#include <gtest/gtest.h>
#include <png.h>

namespace pliant {
namespace {

Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y),
                        static_cast<std::uint8_t>(x * y)};
    }
  }
  return image;
}

TEST(Png, IsReadBackByLibpngPixelForPixel) {
  const Image image = gradient(37, 23);
  const std::string bytes = png_bytes(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()));
  EXPECT_EQ(header.width, 37u);
  EXPECT_EQ(header.height, 23u);
  EXPECT_EQ(header.format, unsigned{PNG_FORMAT_RGB});
  EXPECT_EQ(header.flags & PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB, 0u);
  std::vector<Pixel> pixels(37 * 23);
  ASSERT_TRUE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr));
  EXPECT_EQ(pixels, image.pixels());
}

TEST(Png, IsTheSameForTheSameImage) {
  EXPECT_EQ(png_bytes(gradient(20, 10)), png_bytes(gradient(20, 10)));
}

TEST(Image, BlendingLeavesTheRestAndWhatIsOutside) {
  Image image(3, 2);
  blend(image, 1, 1, {0, 100, 255}, 0.5);
  blend(image, -1, 0, {0, 0, 0}, 1);
  blend(image, 3, 1, {0, 0, 0}, 1);
  EXPECT_EQ(image.at(1, 1), (Pixel{128, 178, 255}));
  EXPECT_EQ(image.at(0, 0), (Pixel{255, 255, 255}));
}

TEST(Image, PastedPicturesLieWhereTheyWereAsked) {
  Image sheet(4, 3);
  paste(sheet, Image(2, 2, {1, 2, 3}), 2, 1);
  EXPECT_EQ(sheet.at(2, 1), (Pixel{1, 2, 3}));
  EXPECT_EQ(sheet.at(3, 2), (Pixel{1, 2, 3}));
  EXPECT_EQ(sheet.at(1, 1), (Pixel{255, 255, 255}));
}

}  // namespace
}  // namespace pliant
