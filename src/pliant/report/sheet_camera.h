#pragma once

#include <Eigen/Core>

#include "pliant/measurement/session.h"

namespace pliant::report {

/// How pictures of a session look at its sheet: from above and from the side to which an overhang
/// falls, without perspective. Unit vectors in world axes.
struct SheetCamera {
  Eigen::Vector3d right, up;  ///< of the picture
  Eigen::Vector3d towards;    ///< the one who looks
  Eigen::Vector3d vertical;   ///< against gravity
};

SheetCamera sheet_camera(const Session& session);

}  // namespace pliant::report
