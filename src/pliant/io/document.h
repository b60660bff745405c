#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// One value of a document with the line it stands on.
struct Node {
  enum class Kind { null, scalar, sequence, mapping };
  struct Field;  ///< key and value of a mapping

  Kind kind = Kind::null;
  std::string text;     ///< of a scalar, unquoted and unescaped; numbers as they were written
  bool quoted = false;  ///< the scalar stood in quotes: a text, even if it looks like a number
  std::vector<Node> items;
  std::vector<Field> fields;  ///< in the order of the file, keys unique
  int line = 0;               ///< counted from 1; a mapping's value carries the line of its key
};

struct Node::Field {
  std::string key;
  Node value;
};

/// The tree that YAML and JSON files are read into. What it means is read with `Value` and
/// `Fields` (fields.h).
struct Document {
  std::string file;  ///< as named by the user, for error messages
  Node root;
};

inline constexpr int kMaxDocumentDepth = 64;
inline constexpr std::size_t kMaxYamlNodes = 1'000'000;  ///< after the expansion of aliases

/// YAML 1.2 in UTF-8 (or UTF-16 with its mark). Aliases are expanded. Refused, with their line:
/// duplicate keys, several documents in one file, merge keys (<<), tags, keys that are no scalars,
/// nesting beyond kMaxDocumentDepth, more than kMaxYamlNodes values, an empty file.
/// @throws InputError
Document read_yaml(const std::filesystem::path& path);
Document parse_yaml(std::string_view text, std::string file);

/// JSON (RFC 8259). Refused, with their line: duplicate keys, text after the value, nesting beyond
/// kMaxDocumentDepth, an empty file.
/// @throws InputError
Document read_json(const std::filesystem::path& path);
Document parse_json(std::string_view text, std::string file);

}  // namespace pliant
