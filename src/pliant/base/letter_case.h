#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// UTF-8 text with the capital letters of English, German and French as small ones; other letters
/// are as they are.
std::string lower_case(std::string_view text);

/// Whether two texts differ in the case of such letters at most.
bool same_letters(std::string_view a, std::string_view b);

}  // namespace pliant
