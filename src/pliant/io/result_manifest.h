#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace pliant {

inline constexpr std::string_view kManifestName = ".pliant-results.json";

/// The hidden list of the files that a command wrote into its folder of results.
struct ResultManifest {
  std::string command;
  std::set<std::string> files;  ///< relative names, safe in the sense of is_safe_relative_name
};

/// Whether a name stays inside its folder: relative, not empty, without "." and "..".
bool is_safe_relative_name(const std::string& name);

/// The list in `directory`; none when there is none.
/// @throws InputError when it cannot be read or names a file outside of `directory`
std::optional<ResultManifest> read_manifest(const std::filesystem::path& directory);

std::string manifest_text(const ResultManifest& manifest);

/// Adds a file to the list in `directory`, where there is one.
/// @throws InputError as `read_manifest`
/// @throws OutputError
void list_result(const std::filesystem::path& directory, const std::string& name);

}  // namespace pliant
