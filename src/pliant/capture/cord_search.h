#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Geometry>

#include "pliant/capture/cord_line.h"

namespace pliant {

/// Looks for a cord in all directions from where it is fastened, as far as the limit of threads
/// allows in several pictures at once.
/// @param last   its line when it was seen before, but `from`: where it is fastened now
/// @param reach  by which it may have turned (rad)
/// @return nothing where no two cameras see it
std::optional<CordLine> found_cord(const CordViews& views, const CordLook& look,
                                   const CordLine& last, double reach);

/// The cord that was pointed at in the picture of one camera.
/// @param fastened  plane near to which it is fastened at its first pixel, rig axes (m)
/// @return nothing where no other camera sees it
std::optional<CordLine> pointed_cord(const CordViews& views, std::size_t camera,
                                     const PointedCord& pointed,
                                     const Eigen::Hyperplane<double, 3>& fastened);

}  // namespace pliant
