#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pliant/io/document.h"

namespace pliant {

/// What a file is, in words, and what may be done with it.
struct FileKind {
  std::string what;       ///< "a photograph"
  std::string way_in;     ///< what its user wants in its place, with the name of the file
  bool is_table = false;  ///< a table of measurements, or may be one
};

/// By the ending of the file's name; none where that does not tell.
std::optional<FileKind> kind_of_file(const std::filesystem::path& file);

/// What a document without a type is (`pliant: TYPE/VERSION`): that of another program; none where
/// it is unknown.
std::optional<FileKind> kind_of_foreign_document(const Document& document);

/// @throws InputError for a file of another kind than a table of measurements
void require_table(const std::filesystem::path& file);

}  // namespace pliant
