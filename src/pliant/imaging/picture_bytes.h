#pragma once

#include <string_view>

namespace pliant {

/// Whether a file begins as a HEIC or AVIF picture does [ISO 14496-12 4.3, 23008-12 10].
bool is_heic(std::string_view bytes);

/// Whether a file begins as a JPEG, PNG, TIFF or BMP does.
bool begins_as_picture(std::string_view bytes);

/// Whether it begins as a JPEG or BMP does, of which decoders make up what is missing.
bool may_be_cut(std::string_view bytes);

/// Whether a JPEG ends before its end marker [T.81 B.1.1.2], or a BMP without compression before
/// its last row. What cameras add behind a picture does no harm.
bool is_cut(std::string_view bytes);

}  // namespace pliant
