#include "pliant/imaging/picture_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "pliant/io/byte_order.h"

namespace pliant {
namespace {

using std::string_view_literals::operator""sv;

constexpr auto kJpeg = "\xff\xd8"sv, kBmp = "BM"sv;

/// Where the next marker stands that is followed by a segment, or ends the picture; the end of the
/// bytes where there is none.
std::size_t next_marker(std::string_view bytes, std::size_t at) {
  for (; at + 1 < bytes.size(); ++at) {
    const auto code = static_cast<unsigned char>(bytes[at + 1]);
    // A stuffed zero, one that stands alone (TEM, RST0 to RST7, SOI), a byte that fills.
    const bool stands_alone = code <= 0x01 || (code >= 0xd0 && code <= 0xd8) || code == 0xff;
    if (bytes[at] == '\xff' && !stands_alone) return at;
  }
  return bytes.size();
}

bool jpeg_is_cut(std::string_view bytes) {
  constexpr char kEnd = '\xd9';
  std::size_t at = next_marker(bytes, 0);
  while (at + 4 <= bytes.size() && bytes[at + 1] != kEnd) {
    at = next_marker(bytes, at + 2 + load_number<std::uint16_t>(&bytes[at + 2], ByteOrder::big));
  }
  return at + 2 > bytes.size() || bytes[at + 1] != kEnd;
}

bool bmp_is_cut(std::string_view bytes) {
  constexpr std::size_t kHeader = 54;
  if (bytes.size() < kHeader) return false;  // of an older kind, by the library alone
  const auto number = [&](std::size_t at) {
    return std::int64_t{load_number<std::int32_t>(&bytes[at], ByteOrder::little)};
  };
  constexpr std::int64_t kLeastHeader = 40, kMasked = 3;
  const std::int64_t compression = number(30);
  if (number(14) < kLeastHeader || (compression != 0 && compression != kMasked)) return false;
  const std::int64_t bits = load_number<std::uint16_t>(&bytes[28], ByteOrder::little);
  const std::int64_t row = (number(18) * bits + 31) / 32 * 4;
  return number(10) + row * std::abs(number(22)) > std::ssize(bytes);
}

}  // namespace

bool is_heic(std::string_view bytes) {
  constexpr std::array kBrands{"heic"sv, "heix"sv, "heim"sv, "heis"sv, "hevc"sv,
                               "hevx"sv, "heif"sv, "mif1"sv, "msf1"sv, "avif"sv};
  constexpr std::size_t kStart = 12;
  return bytes.size() >= kStart && bytes.substr(4, 4) == "ftyp"sv &&
         std::ranges::find(kBrands, bytes.substr(8, 4)) != kBrands.end();
}

bool begins_as_picture(std::string_view bytes) {
  constexpr std::array kBeginnings{kJpeg, "\x89PNG"sv, "II*\0"sv, "MM\0*"sv, kBmp};
  return std::ranges::any_of(kBeginnings, [&](auto begin) { return bytes.starts_with(begin); });
}

bool may_be_cut(std::string_view bytes) {
  return bytes.starts_with(kJpeg) || bytes.starts_with(kBmp);
}

bool is_cut(std::string_view bytes) {
  return bytes.starts_with(kJpeg) ? jpeg_is_cut(bytes) : bmp_is_cut(bytes);
}

}  // namespace pliant
