#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// Bytes as text (RFC 4648, with padding), for XML and data URIs.
std::string base64(std::string_view bytes);

/// The bytes of such a text, or of several one after the other, without its blanks; nothing for
/// one that is none.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace pliant
