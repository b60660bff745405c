#pragma once

#include <string>

#include "pliant/render/image.h"

namespace pliant {

/// The bytes of a PNG file: 8-bit RGB, marked as sRGB; the same for the same image.
std::string png_bytes(const Image& image);

}  // namespace pliant
