#pragma once

#include <optional>

#include "pliant/solver/objective.h"

namespace pliant {

/// A change of the unknowns, shortened to where its points may go.
struct FreeChange {
  Eigen::VectorXd each;   ///< by itself for each free point; for each clip by its least free point
  Eigen::VectorXd alike;  ///< for all by the point that may go least
  bool whole = true;      ///< both are what was asked for
  double lost = 0;        ///< furthest way that a point does not go for what is in its way (m)
  double led = 1;         ///< share of their ways that what is led may go with `each`
};

/// @param led  ways of what is led from outside, one column a point (m); empty: none is
FreeChange free_change(const Objective& objective, const Configuration& at,
                       const Eigen::VectorXd& change, const Eigen::Matrix3Xd& led = {});

/// Whether a part of a change that is free, or what every point may go of one, is free as well. On
/// straight ways it is; points of clips that turn go on arcs.
bool part_is_free(const Objective& objective, const Configuration& from, const Configuration& to);

/// The change that takes points out of the way of what is led from outside; a clip goes as far as
/// its point that has to go furthest. Nothing where there is no room.
/// @param led  where the last step ended, but for what is led: that may be where it goes
std::optional<Eigen::VectorXd> made_way(const Objective& objective, const Configuration& led);

}  // namespace pliant
