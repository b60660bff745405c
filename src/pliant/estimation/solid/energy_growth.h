#pragma once

#include <vector>

#include "pliant/estimation/solid/solid_growth.h"

namespace pliant {

/// Control points of an energy ([T] 4.2.2), spread evenly over the strains of data: on both sides
/// of rest where they have both, in proportion.
/// @param even   the energy is one of the size of the strain
/// @param count  >= 1; one a side at least
std::vector<double> energy_places(const MetricData& data, bool even, int count);

/// The energy stiffness x^2 / 2 by its values at control points.
ScalarCurve quadratic_energy(double stiffness, const std::vector<double>& places, bool even);

/// Grows the cubic Hermite energies of a material, each with evenly spread control points, while
/// one or two more are worth it. They stay convex.
/// @param from  fitted, its energies with one control point a side
GrownSolid grow_energies(SolidProblem& problem, const GrownSolid& from);

}  // namespace pliant
