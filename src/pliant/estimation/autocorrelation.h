#pragma once

#include <vector>

namespace pliant {

/// How many numbers of a series of mean 0 count as one: 1 + 2 sum of its autocorrelations, up to
/// the first that noise could explain. 1 for fewer than 8 numbers, which cannot tell.
double integrated_autocorrelation(const std::vector<double>& series);

}  // namespace pliant
