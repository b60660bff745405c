#pragma once

#include <map>
#include <string>
#include <vector>

namespace pliant {

/// What testing machines call the columns of our tables, in English and German, the likeliest first
/// where a file has several: an extensometer before the crosshead.
const std::map<std::string, std::vector<std::string>>& column_synonyms();

}  // namespace pliant
