#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/io/ply.h"

namespace pliant {

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float64;
  std::optional<PlyType> count_type = {};  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  int line = 0;  ///< of the header
  std::vector<PlyProperty> properties;
};

/// The text at the start of a PLY file that says what the rest holds.
struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;
  std::size_t size = 0;  ///< bytes up to the first element
  int lines = 0;
};

/// Bytes of a number in a binary file.
std::size_t size_of(PlyType type);
bool is_integer(PlyType type);
/// The name that every reader of PLY knows, e.g. "uchar".
std::string_view name_of(PlyType type);

/// @throws InputError with the line; also when the file is too small for the elements it claims
PlyHeader parse_ply_header(std::string_view bytes, const std::string& file);

}  // namespace pliant
