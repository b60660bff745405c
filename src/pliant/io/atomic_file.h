#pragma once

#include <filesystem>
#include <string_view>

namespace pliant {

/// Writes a file that is complete or not there: under a temporary name in the same folder, then
/// renamed over `path`.
/// @throws InputError when nothing can be created there, OutputError when writing fails
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// Creates a file that must not exist yet, writes it to the medium and closes it. A file that could
/// not be completed is removed again.
/// @throws as write_file_atomically
void write_new_file(const std::filesystem::path& path, std::string_view content);

}  // namespace pliant
