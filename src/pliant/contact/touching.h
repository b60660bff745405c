#pragma once

#include <limits>

namespace pliant {

/// What is nearer to each other than the thickness of a contact.
struct Touching {
  int count = 0;                                                    ///< points, or pairs
  double least_distance = std::numeric_limits<double>::infinity();  ///< m
};

}  // namespace pliant
