#pragma once

#include <array>
#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/material/solid/pair_metric.h"

namespace pliant {

/// Names of Gaussian terms of two strains ([T] 4.2.2) at places spread evenly over what the data
/// show of either, as wide as neighbours are apart.
/// @param pair   the two, "green.xx*green.yy"
/// @param count  of places along either strain
std::vector<std::string> gaussian_terms(const std::string& pair, int count, SolidProblem& problem);

/// Gaussian terms at all pairs of places along either strain, their numbers rounded.
/// @param width  along either
std::vector<PairMetric> gaussians_at(PairMetric pair,
                                     const std::array<std::vector<double>, 2>& places,
                                     const std::array<double, 2>& width);

}  // namespace pliant
