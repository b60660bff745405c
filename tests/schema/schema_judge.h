#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pliant/io/document.h"

namespace pliant::test {

/// A document to be judged: its type ("study") and its content.
struct SchemaCase {
  std::string type;
  nlohmann::json document;
};

/// Whether this machine can judge at all: python3 with the package fastjsonschema.
bool can_judge_schemas();

/// What is wrong with each document by the schema of its type; nothing where it is valid.
std::vector<std::optional<std::string>> judge_by_schema(const std::vector<SchemaCase>& cases);

/// What is wrong with a document by the reader of its type (study, lab, scene, session, material);
/// nothing where it reads.
/// @param folder  that the document stands in while it is read, with the files that it names
std::optional<std::string> judge_by_reader(const SchemaCase& document,
                                           const std::filesystem::path& folder);

/// A tree as JSON: what stands in quotes is a text, other scalars are what they look like.
nlohmann::json json_of(const Node& node);

}  // namespace pliant::test
