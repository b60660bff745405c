#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {

/// Names of Gaussian terms of two strains ([T] 4.2.2) at places spread evenly over what the data
/// show of either, as wide as neighbours are apart.
/// @param pair   the two, "green.xx*green.yy"
/// @param count  of places along either strain
std::vector<std::string> gaussian_terms(const std::string& pair, int count, SolidProblem& problem);

}  // namespace pliant
