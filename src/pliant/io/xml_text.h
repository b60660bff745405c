#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// A text as XML has it between tags and in quoted attributes.
std::string xml_text(std::string_view text);

}  // namespace pliant
