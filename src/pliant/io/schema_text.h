#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The document types that have a JSON schema (docs/schema), in the order of their names.
std::vector<std::string> schema_types();

/// The JSON schema (draft-07) of a document type, e.g. "study"; empty for a type without one.
std::string_view schema_text(std::string_view type);

}  // namespace pliant
