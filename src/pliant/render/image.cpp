#include "pliant/render/image.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

Image::Image(int width, int height, const Pixel& fill) : width_(width), height_(height) {
  PLIANT_ASSERT(width > 0 && height > 0, "an image has pixels");
  pixels_.assign(index(0, height), fill);
}

void paste(Image& sheet, const Image& picture, int x, int y) {
  PLIANT_ASSERT(x >= 0 && y >= 0 && x + picture.width() <= sheet.width() &&
                    y + picture.height() <= sheet.height(),
                "a picture fits on its sheet");
  for (int row = 0; row < picture.height(); ++row) {
    for (int column = 0; column < picture.width(); ++column) {
      sheet.at(x + column, y + row) = picture.at(column, row);
    }
  }
}

void blend(Image& image, int x, int y, const Pixel& ink, double coverage) {
  if (x < 0 || y < 0 || x >= image.width() || y >= image.height()) return;
  Pixel& pixel = image.at(x, y);
  for (size_t k = 0; k < 3; ++k) {
    const double mixed = pixel[k] + coverage * (double(ink[k]) - double(pixel[k]));
    pixel[k] = static_cast<std::uint8_t>(std::lround(mixed));
  }
}

}  // namespace pliant
