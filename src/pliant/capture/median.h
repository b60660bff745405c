#pragma once

#include <vector>

namespace pliant {

/// The middle of numbers; 0 of none.
double median(std::vector<double> values);

}  // namespace pliant
