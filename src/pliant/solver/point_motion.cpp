#include "pliant/solver/point_motion.h"

#include <algorithm>

namespace pliant {

int clip_row(const Coordinates& coordinates, int clip) {
  int after = 0;  // free clips from this one on, which have the last rows
  for (int k = clip; k < coordinates.clips(); ++k) after += !coordinates.clip_is_prescribed(k);
  return coordinates.block_rows() - 2 * after;
}

double clip_radius(const Coordinates& coordinates, const Configuration& at, int clip) {
  const Eigen::Vector3d origin = at.clips[static_cast<size_t>(clip)].translation;
  double radius = 0;
  for (const int point : coordinates.clip_points(clip)) {
    radius = std::max(radius, (at.positions.col(point) - origin).norm());
  }
  return radius;
}

Eigen::Matrix3Xd point_motion(const Coordinates& coordinates, const Configuration& at,
                              const Eigen::VectorXd& rates) {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, coordinates.points());
  for (int i = 0; i < coordinates.points(); ++i) {
    if (coordinates.is_free(i)) motion.col(i) = rates.segment<3>(3 * coordinates.row(i));
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const Eigen::Index row = clip_row(coordinates, k);
    const Eigen::Vector3d translation = rates.segment<3>(3 * row);
    const Eigen::Vector3d rotation = rates.segment<3>(3 * row + 3);
    const Eigen::Vector3d origin = at.clips[static_cast<size_t>(k)].translation;
    for (const int point : coordinates.clip_points(k)) {
      const Eigen::Vector3d arm = at.positions.col(point) - origin;
      motion.col(point) = translation + rotation.cross(arm);
    }
  }
  return motion;
}

}  // namespace pliant
