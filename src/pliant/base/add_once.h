#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace pliant {

/// Adds a text, such as a warning that several things share, unless it is there.
inline void add_once(const std::string& text, std::vector<std::string>& texts) {
  if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
}

}  // namespace pliant
