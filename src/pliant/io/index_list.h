#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/io/fields.h"

namespace pliant {

/// Numbers of vertices or faces, counted from 0: listed in the document, or in a text file.
struct IndexList {
  std::vector<int> numbers;
  std::filesystem::path file;  ///< empty where `numbers` holds them
  Location where;
};

/// `[0, 1, 2]`, or the name of a text file of numbers, relative to the document.
/// @throws InputError
IndexList read_index_list(const Value& value);

/// The numbers, in the order of the list, those of a file read from there (separated by blanks,
/// commas or line ends, `#` comments).
/// @param count  numbers must be below it
/// @param kind   of what is numbered, for messages: "vertex", "face"
/// @throws InputError for what is no number, and for a number of nothing
std::vector<int> numbers_of(const IndexList& list, int count, const std::string& kind);

}  // namespace pliant
