#include "pliant/capture/clip_motion.h"

#include <Eigen/Geometry>

namespace pliant {

HeldSide held_side(SampleSide side, int nodes_u, int nodes_v) {
  const bool across_u = side == SampleSide::bottom || side == SampleSide::top;
  const bool is_first = side == SampleSide::bottom || side == SampleSide::left;
  HeldSide held;
  for (int i = 0; i < (across_u ? nodes_u : nodes_v); ++i) {
    const int row = across_u ? (is_first ? 0 : nodes_v - 1) : i;
    const int column = across_u ? i : (is_first ? 0 : nodes_u - 1);
    held.vertices.push_back(row * nodes_u + column);
  }
  held.outward = (is_first ? -1.0 : 1.0) * Eigen::Vector3d::Unit(across_u ? 1 : 0);
  return held;
}

std::optional<Pose> pose_of_points(const LocalMotion& motion, const Eigen::Matrix3Xd& rest,
                                   const Eigen::Vector3d& outward, double far) {
  // A second row of points, a little inside, tells how the clip has turned about its own edge. It
  // says a direction alone: the cloth may have stretched.
  constexpr double kInside = 0.02;  // of the length of the side
  const double inside = kInside * (rest.rightCols<1>() - rest.leftCols<1>()).norm();
  std::vector<Eigen::Vector3d> from, to;
  for (const auto& place : rest.colwise()) {
    const auto moved = motion.at(place.head<2>(), far);
    if (!moved) continue;
    from.emplace_back(place);
    to.push_back(moved->position);
    from.emplace_back(place - inside * outward);
    to.push_back(moved->position - inside * (moved->slope * outward.head<2>()).normalized());
  }
  if (static_cast<Eigen::Index>(from.size()) < rest.cols()) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(from.size());
  const Eigen::Map<const Eigen::Matrix3Xd> a(from.front().data(), 3, count);
  const Eigen::Map<const Eigen::Matrix3Xd> b(to.front().data(), 3, count);
  const Eigen::Matrix4d rigid = Eigen::umeyama(a, b, /*with_scaling=*/false);
  return Pose{Eigen::Quaterniond(Eigen::Matrix3d(rigid.topLeftCorner<3, 3>())).normalized(),
              rigid.topRightCorner<3, 1>()};
}

}  // namespace pliant
