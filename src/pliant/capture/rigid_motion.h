#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pliant {

/// A point turned by a rotation vector (axis times angle, rad), by Rodrigues' formula.
/// @tparam T  double, or a number that carries derivatives
template <class T>
Eigen::Vector<T, 3> turned(const T* rotation, const Eigen::Vector<T, 3>& point) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Eigen::Vector<T, 3> vector(rotation[0], rotation[1], rotation[2]);
  const T square = vector.squaredNorm();
  constexpr double kSmall = 1e-16;  // below it the second order is lost in rounding
  if (!(square > T(kSmall))) return point + vector.cross(point);
  const T angle = sqrt(square);
  const Eigen::Vector<T, 3> axis = vector / angle;
  const T cosine = cos(angle);
  return point * cosine + axis.cross(point) * sin(angle) +
         axis * (axis.dot(point) * (T(1) - cosine));
}

/// Where something lies: a point p of it is at R p + translation.
struct RigidMotion {
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< axis times angle (rad)
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  static RigidMotion of(const Eigen::Isometry3d& isometry) {
    const Eigen::AngleAxisd turn(isometry.linear());
    return {turn.angle() * turn.axis(), isometry.translation()};
  }
  Eigen::Matrix3d matrix() const {
    const double angle = rotation.norm();
    if (angle == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  }
  Eigen::Isometry3d isometry() const {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = matrix();
    result.translation() = translation;
    return result;
  }
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return matrix() * point + translation;
  }
  RigidMotion inverse() const { return of(isometry().inverse()); }
  /// `second` first, then this one.
  RigidMotion operator*(const RigidMotion& second) const {
    return of(isometry() * second.isometry());
  }
};

}  // namespace pliant
