#pragma once

#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {

/// Rows that are independent as far as noise goes, by how the differences that a rich material
/// leaves hang together.
/// @param rich  as many control points as it may have; it is fitted roughly
double effective_rows(SolidProblem& problem, Material rich);

}  // namespace pliant
