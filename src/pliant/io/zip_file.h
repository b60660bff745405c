#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// The names of the files in a zip archive, in its order (folders left out).
/// @throws InputError when `path` is no readable zip archive
std::vector<std::string> zip_entries(const std::filesystem::path& path);

/// The content of one file of a zip archive.
/// @throws InputError when it is not there, is damaged or encrypted, or unpacks to more than
///         `limit` bytes
std::string read_zip_entry(const std::filesystem::path& path, const std::string& name,
                           std::size_t limit = std::size_t{256} << 20);

}  // namespace pliant
