#pragma once

#include <vector>

namespace pliant::report {

/// At most `most` of `count` frames, evenly, the first and the last among them.
std::vector<int> evenly_chosen(int count, int most);

}  // namespace pliant::report
