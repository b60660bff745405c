#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/estimation/convex_search.h"
#include "pliant/material/material.h"

namespace pliant {

/// Where an energy shall be convex in two components of the Green strain, all others being zero.
struct PairDomain {
  std::array<int, 2> strains{};                    ///< columns of the Green strain
  std::array<std::pair<double, double>, 2> range;  ///< of either
};

/// Numbers of a solid's laws that make its energy convex ([T] 4.2.3, 4.3.3), in the order of
/// `set_numbers`.
///
/// - A cubic Hermite energy: exactly, its second derivatives at both ends of each piece.
/// - Terms of two strains: the energy by Green strains (`by_green_strains`) in these two, at a grid
///   of samples of their domain. The least eigenvalue of its second derivative H(p) is a concave
///   function of the numbers, in which H is linear; where it is negative, v its eigenvector,
///   v^T H(p) v >= 0 is a condition.
/// @param domains  of its terms of two strains
ConvexSet convex_numbers(const Material& form, const std::vector<PairDomain>& domains);

/// The elastic components of a solid that act on components of the Green strain, their sums and
/// traces: an energy that laws of one strain, each convex, leave convex in these strains. Volume
/// and invariants are no such functions of them.
Material by_green_strains(const Material& material);

/// The least eigenvalue of second derivatives of that energy in two strains over a grid of samples,
/// as a share of the largest one there; below 0 the energy is not convex.
double least_convexity(const Material& material, const PairDomain& domain);

/// What a material tells of where its terms of two strains hold: ranges of the components of either
/// strain, and places of Gaussians.
/// @return nothing where it tells nothing of one of them
std::optional<PairDomain> stated_domain(const Material& material, const std::string& pair);

}  // namespace pliant
