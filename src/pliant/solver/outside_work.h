#pragma once

#include "pliant/solver/objective.h"

namespace pliant {

/// Work that what comes from outside does during a step (J): points, clips and bodies that are led
/// against the forces of its end, forces and ends of cords that change where it began.
///
/// What a backward Euler step of convex potentials has at its end is at most what it had at its
/// begin and this work; the rest is what the step loses.
/// @param to        its end; it begins where the objective's conditions say
/// @param gradient  dE / d points of the objective there (N)
/// @param before    what came from outside where it began
double outside_work(const Objective& objective, const Configuration& to,
                    const Eigen::Matrix3Xd& gradient, const Controls& before);

}  // namespace pliant
