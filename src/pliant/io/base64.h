#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// Bytes as text (RFC 4648, with padding), for XML and data URIs.
std::string base64(std::string_view bytes);

}  // namespace pliant
