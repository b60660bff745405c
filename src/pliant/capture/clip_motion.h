#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "pliant/capture/dic_file.h"
#include "pliant/capture/local_motion.h"
#include "pliant/geometry/pose.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// What a clip holds of the sample, a rectangle at its side.
struct HeldPlace {
  Eigen::AlignedBox2d cloth;  ///< at rest (m)
  std::vector<int> vertices;  ///< in it
  std::vector<int> edge;      ///< of them: from which the cloth comes, in order along it
  Eigen::Vector3d outward;    ///< away from the sample
};

/// Where the cloth of a clip is at rest (m).
/// @throws InputError where that is not on the sample
Eigen::AlignedBox2d held_cloth(const DicFile& dic, const DicClip& clip);

/// @param rest  mesh with vertices along the edges of the clip's cloth
HeldPlace held_place(const DicFile& dic, const DicClip& clip, const TriangleMesh& rest);

/// @param held  of each clip
std::vector<SessionClip> session_clips(const std::vector<DicClip>& clips,
                                       const std::vector<HeldPlace>& held);

/// One motion, then another.
Pose one_after_another(const Pose& first, const Pose& second);

/// How a clip has moved if the cloth at its edge has moved with it: the rigid motion nearest to
/// that of the points beside it.
/// @param rest  3 x vertices of the edge, in order, at rest (m)
/// @param far   how far the points beside it may be (m)
/// @return nothing where fewer than half of the vertices have points so near
std::optional<Pose> pose_of_points(const LocalMotion& motion, const Eigen::Matrix3Xd& rest,
                                   const Eigen::Vector3d& outward, double far);

}  // namespace pliant
