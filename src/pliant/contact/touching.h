#pragma once

#include <limits>
#include <vector>

namespace pliant {

/// What is nearer to each other than the thickness of a contact.
struct Touching {
  int count = 0;                                                    ///< points, or pairs
  double least_distance = std::numeric_limits<double>::infinity();  ///< m
  /// What is there: each part by its points of the system, a vertex, an edge's two or a face's
  /// three. A convex body has none itself.
  std::vector<std::vector<int>> nearest = {};
};

}  // namespace pliant
