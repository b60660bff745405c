#pragma once

#include <array>
#include <utility>
#include <vector>

#include "pliant/estimation/convex_search.h"
#include "pliant/material/material.h"

namespace pliant {

/// Where an energy shall be convex in two components of the Green strain, all others being zero.
struct PairDomain {
  std::array<int, 2> strains{};                   ///< columns of the Green strain
  std::array<std::pair<double, double>, 2> range;  ///< of either
};

/// Numbers of a solid's laws that make its energy convex ([T] 4.2.3, 4.3.3), in the order of
/// `set_numbers`.
///
/// - A cubic Hermite energy: exactly, its second derivatives at both ends of each piece.
/// - Terms of two strains: the whole energy in these two, at a grid of samples of their domain. The
///   least eigenvalue of its second derivative H(p) is a concave function of the numbers, in which H
///   is linear; where it is negative, v its eigenvector, v^T H(p) v >= 0 is a condition.
/// @param form     what remembers, and limits, have no part in it
/// @param domains  of its terms of two strains
/// @throws InputError where an energy is not linear in its numbers and there are such terms
ConvexSet convex_numbers(const Material& form, const std::vector<PairDomain>& domains);

/// The least eigenvalue of the energy's second derivative in two strains over a grid of samples, as
/// a share of the largest one there; below 0 the energy is not convex.
double least_convexity(const Material& material, const PairDomain& domain);

}  // namespace pliant
