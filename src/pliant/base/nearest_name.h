#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The candidate that `word` most likely means (smallest edit distance, letters' case aside), for
/// "did you mean"; empty when none is near enough to be a slip of the keyboard.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);
std::string nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// ` (did you mean "near"?)` for the end of a problem's text; empty when no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// `"a", "b" or "c"`: the names an error message offers, at most twelve of them.
std::string list_of_names(std::span<const std::string> names);

}  // namespace pliant
