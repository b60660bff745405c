#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {

/// Gives a fitted material limits of energy and fits both together: each limit begins at some of
/// the energies that the experiments reach without it, and where the differences become least is
/// kept. [T] 4.4 alternates between elasticity and limit.
/// @param limits    components of each; the material has laws of all
/// @param first     where the fit began: there the energies are looked for that the fit without a
///                  limit has lost
/// @param material  fitted; gets the limits
/// @param fitted    how
/// @return how the material with its limits fits
/// @throws SolverError where no limit lets the material be predicted
LeastSquaresSummary add_limits(SolidProblem& problem,
                               const std::vector<std::vector<std::string>>& limits,
                               const Material& first, Material& material,
                               const LeastSquaresSummary& fitted);

}  // namespace pliant
