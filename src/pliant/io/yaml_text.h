#pragma once

#include <string>

namespace pliant {

/// A text in quotes, as YAML reads it back whatever is in it; what is no UTF-8 is replaced.
std::string yaml_text(const std::string& text);

}  // namespace pliant
