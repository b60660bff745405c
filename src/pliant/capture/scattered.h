#pragma once

#include <vector>

namespace pliant {

/// Some of the numbers below `count`, increasing, spread by the golden ratio: those of a grid, row
/// by row, lie in no line.
/// @param wanted  at most so many
std::vector<int> scattered(int count, int wanted);

}  // namespace pliant
