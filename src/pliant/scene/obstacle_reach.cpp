#include "pliant/scene/obstacle_reach.h"

#include <algorithm>

#include "pliant/scene/obstacle_depth.h"

namespace pliant {
namespace {

void note(int number, double depth, std::optional<DeepPart>& deepest) {
  if (depth > 0 && (!deepest || depth > deepest->depth)) deepest = DeepPart{number, depth};
}

}  // namespace

ObstacleReach reach_into(const ObstacleShape& shape, const Pose& body,
                         const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& faces,
                         const std::function<bool(int)>& is_led) {
  ObstacleReach reach;
  for (int face = 0; face < faces.cols(); ++face) {
    Eigen::Matrix3d corners;
    bool is_led_inside = false;
    for (int k = 0; k < 3; ++k) {
      const int point = faces(k, face);
      corners.col(k) = body.local(positions.col(point));
      const double depth = depth_of_place(shape, corners.col(k));
      if (depth <= 0) continue;
      if (is_led(point)) {
        is_led_inside = true;
      } else {
        note(point, depth, reach.vertex);
      }
    }
    if (!is_led_inside) note(face, depth_of_triangle(shape, corners), reach.face);
  }
  return reach;
}

std::vector<ObstacleReach> obstacle_reaches(const Scene& scene, const SceneSystem& built,
                                            const State& state) {
  const Coordinates& coordinates = built.system->coordinates();
  std::vector<ObstacleReach> reaches;
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (!obstacle.shape()) continue;
    const Pose body = obstacle.motion ? pose_at(*obstacle.motion, state.time) : Pose{};
    reaches.push_back(reach_into(*obstacle.shape(), body, state.configuration.positions,
                                 built.faces,
                                 [&](int point) { return coordinates.is_led(point); }));
    reaches.back().obstacle = obstacle.name;
  }
  return reaches;
}

}  // namespace pliant
