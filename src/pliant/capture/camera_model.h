#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/capture/rigid_motion.h"

namespace pliant {

/// A camera's own numbers, in this order: fx, fy, cx, cy (pixels), k1, k2, p1, p2, k3.
inline constexpr int kIntrinsics = 9;
using Intrinsics = Eigen::Vector<double, kIntrinsics>;
inline constexpr const char* kIntrinsicNames[kIntrinsics] = {"fx", "fy", "cx", "cy", "k1",
                                                             "k2", "p1", "p2", "k3"};

/// Where a lens shows what a pinhole would show at `straight` (x / z, y / z): radial and tangential
/// distortion ([Brown1971]; signs and order of OpenCV).
template <class T>
Eigen::Vector<T, 2> distorted(const T* intrinsics, const Eigen::Vector<T, 2>& straight) {
  const T &k1 = intrinsics[4], &k2 = intrinsics[5], &p1 = intrinsics[6], &p2 = intrinsics[7],
          &k3 = intrinsics[8];
  const T &x = straight.x(), &y = straight.y();
  const T square = x * x + y * y;
  const T radial = T(1) + square * (k1 + square * (k2 + square * k3));
  return {x * radial + T(2) * p1 * x * y + p2 * (square + T(2) * x * x),
          y * radial + p1 * (square + T(2) * y * y) + T(2) * p2 * x * y};
}

/// The pixel (column, row; the middle of the first is (0, 0)) that shows a point.
/// @param point  in camera axes: x along rows, y down columns, z away from the camera; z > 0
template <class T>
Eigen::Vector<T, 2> pixel_of(const T* intrinsics, const Eigen::Vector<T, 3>& point) {
  const Eigen::Vector<T, 2> straight(point.x() / point.z(), point.y() / point.z());
  const Eigen::Vector<T, 2> bent = distorted(intrinsics, straight);
  return {intrinsics[0] * bent.x() + intrinsics[2], intrinsics[1] * bent.y() + intrinsics[3]};
}

/// A pixel and how it changes with the point that it shows.
struct Projection {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> by_point;                 ///< pixels / m
  Eigen::Matrix<double, 2, kIntrinsics> by_intrinsics;  ///< of the camera
};

/// A line of sight.
struct SightRay {
  Eigen::Vector3d from;       ///< the camera's centre (m)
  Eigen::Vector3d direction;  ///< unit
};

/// A pinhole camera with radial and tangential distortion and its place in a rig: what calibration
/// estimates, tracking measures with and renderers draw by.
struct CameraModel {
  Intrinsics intrinsics = (Intrinsics() << 1000, 1000, 0, 0, 0, 0, 0, 0, 0).finished();
  RigidMotion pose;  ///< of the rig in camera axes: a point p of the rig (m) is at pose * p
  int columns = 0, rows = 0;  ///< of its pictures

  /// Nothing where a point of the rig is behind the camera, or so far aside that the distortion
  /// folds the picture over. It may be outside of the picture.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;
  std::optional<Projection> project_with_derivatives(const Eigen::Vector3d& point) const;
  /// Where a pinhole would show what is seen at a pixel: (x / z, y / z). Nothing where no direction
  /// is seen at that pixel.
  std::optional<Eigen::Vector2d> straight(const Eigen::Vector2d& pixel) const;
  /// Along what is seen at a pixel, in rig axes.
  std::optional<SightRay> ray(const Eigen::Vector2d& pixel) const;
  /// In rig axes (m).
  Eigen::Vector3d centre() const;
};

}  // namespace pliant
