#pragma once

#include <cstddef>
#include <vector>

#include "pliant/render/colour.h"

namespace pliant {

/// A picture of 8-bit sRGB pixels.
class Image {
 public:
  /// @param width, height  pixels, > 0
  Image(int width, int height, const Pixel& fill = {255, 255, 255});

  int width() const { return width_; }
  int height() const { return height_; }

  /// @param x, y  from the left and from the top
  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// Row after row from the top.
  const std::vector<Pixel>& pixels() const { return pixels_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Pixel> pixels_;
};

/// Copies `picture` onto `sheet` with its upper left corner at (x, y); it must fit.
void paste(Image& sheet, const Image& picture, int x, int y);

/// Lays `ink` over a pixel, which stays as it is at coverage 0; nothing happens outside the image.
void blend(Image& image, int x, int y, const Pixel& ink, double coverage);

}  // namespace pliant
