#pragma once

#include "pliant/solver/objective.h"

namespace pliant {

/// A change of the unknowns, shortened to where its points may go.
struct FreeChange {
  Eigen::VectorXd each;   ///< by itself for each free point; for each clip by its least free point
  Eigen::VectorXd alike;  ///< for all by the point that may go least
  bool whole = true;      ///< both are what was asked for
  bool obstructed = false;  ///< something in the way has shortened it
};

FreeChange free_change(const Objective& objective, const Configuration& at,
                       const Eigen::VectorXd& change);

/// The change that takes points out of the way of what is led from outside; a clip goes as far as
/// its point that has to go furthest.
Eigen::VectorXd made_way(const Objective& objective, const Configuration& at);

}  // namespace pliant
