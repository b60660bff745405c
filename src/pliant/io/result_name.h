#pragma once

#include <set>
#include <string>
#include <string_view>

#include "pliant/io/fields.h"

namespace pliant {

/// Reads the name of something whose results are files of that name: it may hold letters, digits,
/// `-`, `_` and `.`, and each name counts once.
/// @param what   the thing, for messages: "an experiment"
/// @param taken  names so far; gets the new one
/// @throws InputError
std::string read_result_name(const Value& value, std::string_view what,
                             std::set<std::string>& taken);

/// Reads an experiment's name.
std::string read_experiment_name(const Value& value, std::set<std::string>& taken);

}  // namespace pliant
