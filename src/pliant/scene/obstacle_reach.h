#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pliant/geometry/pose.h"
#include "pliant/scene/scene_system.h"

namespace pliant {

/// A vertex or a face of cloth, counted over all cloth, and how deep it is in a convex obstacle (m,
/// above 0).
struct DeepPart {
  int number = 0;
  double depth = 0;
};

/// What of cloth is deepest in a convex obstacle, by a test that knows nothing of contact. What is
/// led from outside goes through anything: its vertices do not count, nor faces for these.
struct ObstacleReach {
  std::string obstacle;            ///< its name
  std::optional<DeepPart> vertex;  ///< contact keeps them all out
  std::optional<DeepPart> face;    ///< between its vertices, which contact does not look at
};

/// @param body    where the obstacle stands, which stays without a name
/// @param faces   of all cloth, as columns of `positions` (m)
/// @param is_led  whether a point is, or an axis of it
ObstacleReach reach_into(const ObstacleShape& shape, const Pose& body,
                         const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& faces,
                         const std::function<bool(int)>& is_led);

/// Of each convex obstacle of a scene, in their order.
std::vector<ObstacleReach> obstacle_reaches(const Scene& scene, const SceneSystem& built,
                                            const State& state);

}  // namespace pliant
