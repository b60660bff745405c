#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace pliant {

/// The bytes of numbers that stand side by side.
/// @param numbers  outlive the result
template <class Array>
std::string_view as_bytes(const Array& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()),
          sizeof(*numbers.data()) * static_cast<std::size_t>(numbers.size())};
}

/// SHA-256 in lower-case hexadecimal, as `sha256sum` prints it.
std::string sha256_of(std::string_view bytes);

/// @throws InputError when the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// The digest of a file, or of a folder: of the names and digests of all files in it.
/// @throws InputError when a file cannot be read
std::string sha256_of_path(const std::filesystem::path& path);

}  // namespace pliant
