#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pliant {

inline constexpr std::size_t kMaxTextFileSize = std::size_t{256} << 20;

/// The bytes of a regular file.
/// @throws InputError for a directory, a device, a missing or unreadable file, and one of more than
///         `limit` bytes (found out before it is read)
std::string read_text_file(const std::filesystem::path& path, std::size_t limit = kMaxTextFileSize);

/// A file's bytes as UTF-8 without byte order mark.
///
/// A byte order mark decides (UTF-8, UTF-16); without one the bytes are in `encoding`, any name
/// that iconv knows, or in UTF-8 when that is empty.
/// @param file  name for error messages
/// @throws InputError with the line of the first byte that does not fit the encoding, and for text
///         that holds NUL characters (a binary file, UTF-16 without its mark)
std::string decode_text(std::string bytes, const std::string& encoding, const std::string& file);

}  // namespace pliant
