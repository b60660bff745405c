#pragma once

#include <string_view>

namespace pliant {

/// Whether `name` matches `pattern`, in which `*` stands for any text.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace pliant
