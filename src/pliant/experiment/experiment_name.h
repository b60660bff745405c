#pragma once

#include <set>
#include <string>

#include "pliant/io/fields.h"

namespace pliant {

/// Reads an experiment's name: results are files of that name, so it may hold letters, digits, `-`,
/// `_` and `.`, and each name counts once.
/// @param taken  names so far; gets the new one
/// @throws InputError
std::string read_experiment_name(const Value& value, std::set<std::string>& taken);

}  // namespace pliant
