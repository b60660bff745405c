#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/capture/dic_file.h"
#include "pliant/capture/local_motion.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// A side of the sample that a clip holds.
struct HeldSide {
  std::vector<int> vertices;
  Eigen::Vector3d outward;  ///< away from the sample
};

HeldSide held_side(SampleSide side, int nodes_u, int nodes_v);

/// How a clip has moved if the cloth at its edge has moved with it: the rigid motion nearest to
/// that of the points beside it.
/// @param rest  3 x vertices of the side, at rest (m)
/// @param far   how far the points beside it may be (m)
/// @return nothing where fewer than half of the vertices have points so near
std::optional<Pose> pose_of_points(const LocalMotion& motion, const Eigen::Matrix3Xd& rest,
                                   const Eigen::Vector3d& outward, double far);

}  // namespace pliant
