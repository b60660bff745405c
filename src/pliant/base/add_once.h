#pragma once

#include <algorithm>
#include <vector>

namespace pliant {

/// Adds what several things share, such as a warning, to a list unless it is there.
template <class Given, class T>
void add_once(const Given& given, std::vector<T>& list) {
  if (std::ranges::find(list, given) == list.end()) list.emplace_back(given);
}

}  // namespace pliant
