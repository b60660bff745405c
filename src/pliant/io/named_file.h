#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/fields.h"

namespace pliant {

/// The path of a file that a document names, relative to the document.
/// @param expected  what the file should be, for the message
/// @throws InputError where no such file exists
std::filesystem::path read_named_file(const Value& value, const std::string& expected);

}  // namespace pliant
