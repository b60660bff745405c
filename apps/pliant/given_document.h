#pragma once

#include <filesystem>
#include <string>

namespace pliant {

/// The document of a type (study, lab, scene, material) that a command was given: the file, or in a
/// folder the file TYPE.yaml, else the only document of the type.
/// @throws InputError for a file of another kind, with the way in from there
std::filesystem::path given_document(const std::filesystem::path& file, const std::string& type);

}  // namespace pliant
