#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "pliant/measurement/session.h"

namespace pliant {

/// The table over whose edge a sheet is pushed.
struct DicTable {
  RestAxis axis = RestAxis::u;  ///< along which the sheet is pushed, across the edge
  double edge = 0;              ///< under the sheet in the first frame (m)
};

/// Where a sheet is that lies on a table in part.
struct PushedSheet {
  Eigen::Isometry3d motion;  ///< of what lies on the table, since the first frame
  double edge = 0;           ///< of the table, in the sheet's own coordinate by now (m)
  double turn = 0;           ///< of the edge in the sheet's plane (rad)
  int held = 0;              ///< points that lie on the table
};

/// The table stays where it is: what lies on it moves as a rigid body, which tells where its edge
/// is under the sheet.
/// @param rest, moved  points of the sheet (m), in its axes in the first frame
/// @param middle       of the sheet along the edge (m)
/// @param before       edge in the frame before; the sheet is pushed on
/// @param margin       beside the edge, where a sheet may be bent already (m)
/// @return nothing where hardly a point lies on the table
std::optional<PushedSheet> pushed_sheet(const Eigen::Matrix3Xd& rest, const Eigen::Matrix3Xd& moved,
                                        const DicTable& table, double middle, double before,
                                        double margin);

}  // namespace pliant
