#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pliant {

// Files that a command leaves for itself: a line with their type, e.g. "checkpoint/1", and a digest
// of the bytes that follow.

std::string sealed_bytes(std::string_view type, std::string_view content);

/// Whether a file begins as one of a type does.
bool is_sealed(const std::filesystem::path& file, std::string_view type);

/// The content of a file, undamaged.
/// @param noun  what the file should be, e.g. "checkpoint"
/// @param command  that writes such files
/// @throws InputError for a file of another type, and a damaged one
std::string read_sealed(const std::filesystem::path& file, std::string_view type,
                        std::string_view noun, std::string_view command);

}  // namespace pliant
