#include "pliant/imaging/picture_file.h"

#include <string>

#include <gdk-pixbuf/gdk-pixbuf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kColumns = 300, kRows = 200;

/// A ramp of grey as a file of a kind that the library names.
std::string file_of(const char* kind) {
  GdkPixbuf* picture = gdk_pixbuf_new(GDK_COLORSPACE_RGB, FALSE, 8, kColumns, kRows);
  for (int row = 0; row < kRows; ++row) {
    guchar* pixels = gdk_pixbuf_get_pixels(picture) + row * gdk_pixbuf_get_rowstride(picture);
    for (int i = 0; i < 3 * kColumns; ++i) pixels[i] = static_cast<guchar>(i + row);
  }
  gchar* bytes = nullptr;
  gsize size = 0;
  EXPECT_TRUE(gdk_pixbuf_save_to_buffer(picture, &bytes, &size, kind, nullptr, nullptr));
  std::string file(bytes, size);
  g_free(bytes);
  g_object_unref(picture);
  return file;
}

std::string refused(const std::string& name, const std::string& bytes) {
  const test::TemporaryFolder folder;
  const auto file = folder.write(name, bytes);
  return test::input_error_of([&] { read_picture(file); }).what();
}

class WholePicture : public testing::TestWithParam<const char*> {};

TEST_P(WholePicture, IsReadAndHalfOfItIsRefused) {
  const test::TemporaryFolder folder;
  const std::string whole = file_of(GetParam());
  const ColourPhoto read = read_picture(folder.write("a", whole));
  EXPECT_EQ(read.columns, kColumns);
  EXPECT_EQ(read.rows, kRows);
  EXPECT_THAT(refused("half", whole.substr(0, whole.size() / 2)),
              AllOf(HasSubstr("half: "), HasSubstr("ends too early")));
}

INSTANTIATE_TEST_SUITE_P(Files, WholePicture, testing::Values("jpeg", "png", "bmp", "tiff"),
                         [](const auto& item) { return std::string(item.param); });

// Cameras put a small picture before the picture and films behind it, which have ends of their own.
TEST(Jpeg, EndsWhereItsOwnPictureDoes) {
  const std::string plain = file_of("jpeg");
  const std::string small("\xff\xe1\x00\x06\xff\xd8\xff\xd9", 8);
  const std::string whole = plain.substr(0, 2) + small + plain.substr(2);
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_picture(folder.write("a.jpg", whole + std::string(50, '\0'))).rows, kRows);
  EXPECT_THAT(refused("b.jpg", whole.substr(0, whole.size() - 1)), HasSubstr("ends too early"));
}

TEST(PictureFile, OfAPhoneIsSaidToBeHeic) {
  for (const char* brand : {"heic", "mif1", "avif"}) {
    const std::string start = std::string("\0\0\0\x18", 4) + "ftyp" + brand;
    EXPECT_THAT(refused("1.heic", start),
                AllOf(HasSubstr("1.heic: is a HEIC or AVIF picture"), HasSubstr("heif-convert")));
  }
  EXPECT_THAT(refused("1.mp4", std::string("\0\0\0\x18", 4) + "ftypisom"),
              HasSubstr("is no picture that can be read"));
}

}  // namespace
}  // namespace pliant
