#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace pliant {

/// The order of a number's bytes in a file.
enum class ByteOrder { little, big };

inline constexpr ByteOrder kNativeByteOrder =
    std::endian::native == std::endian::little ? ByteOrder::little : ByteOrder::big;

/// The number that starts at `bytes`.
template <typename T>
T load_number(const char* bytes, ByteOrder order) {
  std::array<char, sizeof(T)> part;
  std::copy_n(bytes, sizeof(T), part.begin());
  if (order != kNativeByteOrder) std::reverse(part.begin(), part.end());
  return std::bit_cast<T>(part);
}

template <typename T>
void append_number(T value, ByteOrder order, std::string& bytes) {
  auto part = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != kNativeByteOrder) std::reverse(part.begin(), part.end());
  bytes.append(part.data(), part.size());
}

}  // namespace pliant
