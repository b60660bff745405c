#include "pliant/imaging/picture_file.h"

#include <cmath>
#include <fstream>
#include <memory>
#include <new>

#include <gdk-pixbuf/gdk-pixbuf.h>

#include "pliant/base/errors.h"
#include "pliant/imaging/deep_picture.h"
#include "pliant/imaging/picture_bytes.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

constexpr int kColours = 3, kBits = 8;

struct Unreference {
  void operator()(GdkPixbuf* picture) const { g_object_unref(picture); }
};
using Pixbuf = std::unique_ptr<GdkPixbuf, Unreference>;

struct Free {
  void operator()(gchar* bytes) const { g_free(bytes); }
  void operator()(GError* error) const { g_error_free(error); }
};

ColourPhoto grey_levels(const Photo& photo) {
  constexpr float kWhite = 255;
  ColourPhoto picture{static_cast<int>(photo.rows()), static_cast<int>(photo.cols()), {}};
  picture.levels.reserve(static_cast<std::size_t>(kColours * photo.size()));
  for (const float brightness : photo.reshaped<Eigen::RowMajor>()) {
    const auto level = static_cast<unsigned char>(std::lround(kWhite * brightness));
    picture.levels.insert(picture.levels.end(), kColours, level);
  }
  return picture;
}

[[noreturn]] void refuse_cut(const std::filesystem::path& file) {
  throw InputError({file.string()}, "ends too early or is damaged", "a whole picture");
}

/// Its first bytes, which tell its kind.
std::string start_of(const std::filesystem::path& file) {
  std::string start(12, '\0');
  std::ifstream open(file, std::ios::binary);
  open.read(start.data(), std::ssize(start));
  start.resize(static_cast<std::size_t>(open.gcount()));
  return start;
}

bool is_cut_file(const std::filesystem::path& file) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  return may_be_cut(start_of(file)) && is_cut(read_text_file(file, kMost));
}

[[noreturn]] void refuse_unread(const std::filesystem::path& file, const GError& error) {
  const bool is_decoders = error.domain == GDK_PIXBUF_ERROR;  // not of the file system
  const std::string start = is_decoders ? start_of(file) : "";
  if (is_heic(start)) {
    throw InputError({file.string()}, "is a HEIC or AVIF picture, which has to be converted first",
                     "JPEG or PNG: set the phone's camera to `most compatible`, or convert it, "
                     "e.g. `heif-convert 1.heic 1.png`");
  }
  if (begins_as_picture(start)) refuse_cut(file);
  throw InputError({file.string()}, "is no picture that can be read",
                   "a photograph: JPEG, PNG, TIFF or BMP");
}

/// As it is stored.
Pixbuf stored_picture(const std::filesystem::path& file) {
  GError* error = nullptr;
  Pixbuf stored(gdk_pixbuf_new_from_file(file.c_str(), &error));
  if (!stored) {
    const std::unique_ptr<GError, Free> kept(error);
    refuse_unread(file, *error);
  }
  if (is_cut_file(file)) refuse_cut(file);
  return stored;
}

/// The library gives none where memory ends.
Pixbuf owned(GdkPixbuf* picture) {
  if (!picture) throw std::bad_alloc();
  return Pixbuf(picture);
}

}  // namespace

ColourPhoto read_picture(const std::filesystem::path& file) {
  if (const auto deep = read_deep_picture(file)) return grey_levels(*deep);
  return read_shallow_picture(file);
}

ColourPhoto read_shallow_picture(const std::filesystem::path& file) {
  const Pixbuf stored = stored_picture(file);
  const Pixbuf turned = owned(gdk_pixbuf_apply_embedded_orientation(stored.get()));
  ColourPhoto picture{gdk_pixbuf_get_height(turned.get()), gdk_pixbuf_get_width(turned.get()), {}};
  picture.levels.resize(static_cast<std::size_t>(kColours) * picture.rows * picture.columns);
  auto level = picture.levels.begin();
  const int channels = gdk_pixbuf_get_n_channels(turned.get());
  const guchar* row = gdk_pixbuf_read_pixels(turned.get());
  for (int y = 0; y < picture.rows; ++y, row += gdk_pixbuf_get_rowstride(turned.get())) {
    const guchar* pixel = row;
    for (int x = 0; x < picture.columns; ++x, pixel += channels) {
      for (const int colour : {2, 1, 0}) *level++ = pixel[colour];
    }
  }
  return picture;
}

std::string png_of(const ColourPhoto& picture) {
  const Pixbuf written = owned(gdk_pixbuf_new(GDK_COLORSPACE_RGB, /*has_alpha=*/FALSE, kBits,
                                              picture.columns, picture.rows));
  guchar* row = gdk_pixbuf_get_pixels(written.get());
  auto level = picture.levels.begin();
  for (int y = 0; y < picture.rows; ++y, row += gdk_pixbuf_get_rowstride(written.get())) {
    for (int x = 0; x < kColours * picture.columns; x += kColours) {
      for (const int colour : {2, 1, 0}) row[x + colour] = *level++;
    }
  }
  gchar* bytes = nullptr;
  gsize size = 0;
  constexpr const char* kFast = "1";
  if (!gdk_pixbuf_save_to_buffer(written.get(), &bytes, &size, "png", nullptr, "compression", kFast,
                                 nullptr)) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<gchar, Free> kept(bytes);
  return {bytes, size};
}

}  // namespace pliant
