#include "pliant/capture/camera_model.h"

#include <cmath>

#include <Eigen/LU>

namespace pliant {
namespace {

// Derivative of distorted() by the straight place.
Eigen::Matrix2d distortion_slope(const Intrinsics& intrinsics, const Eigen::Vector2d& straight) {
  const double k1 = intrinsics(4), k2 = intrinsics(5), p1 = intrinsics(6), p2 = intrinsics(7),
               k3 = intrinsics(8);
  const double x = straight.x(), y = straight.y(), square = straight.squaredNorm();
  const double radial = 1 + square * (k1 + square * (k2 + square * k3));
  const double by_square = k1 + square * (2 * k2 + square * 3 * k3);
  const double mixed = 2 * x * y * by_square + 2 * p1 * x + 2 * p2 * y;
  Eigen::Matrix2d slope;
  slope << radial + 2 * x * x * by_square + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, radial + 2 * y * y * by_square + 6 * p1 * y + 2 * p2 * x;
  return slope;
}

// Farther out a lens may be modelled to show the same pixel again: along a radius the picture must
// grow.
bool is_before_fold(const Intrinsics& intrinsics, double square) {
  const double k1 = intrinsics(4), k2 = intrinsics(5), k3 = intrinsics(8);
  constexpr int kSteps = 16;
  for (int i = 1; i <= kSteps; ++i) {
    const double s = square * i / kSteps;
    if (!(1 + s * (3 * k1 + s * (5 * k2 + s * 7 * k3)) > 0)) return false;
  }
  return true;
}

std::optional<Eigen::Vector2d> straight_of(const Eigen::Vector3d& local, const Intrinsics& own) {
  if (!(local.z() > 0)) return std::nullopt;
  const Eigen::Vector2d straight = local.head<2>() / local.z();
  if (!is_before_fold(own, straight.squaredNorm())) return std::nullopt;
  return straight;
}

}  // namespace

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = pose * point;
  if (!straight_of(local, intrinsics)) return std::nullopt;
  return pixel_of(intrinsics.data(), local);
}

std::optional<Projection> CameraModel::project_with_derivatives(
    const Eigen::Vector3d& point) const {
  const Eigen::Matrix3d rotation = pose.matrix();
  const Eigen::Vector3d local = rotation * point + pose.translation;
  const auto straight = straight_of(local, intrinsics);
  if (!straight) return std::nullopt;
  const Eigen::Vector2d focal = intrinsics.head<2>();
  const Eigen::Vector2d bent = distorted(intrinsics.data(), *straight);
  Projection result;
  result.pixel = focal.cwiseProduct(bent) + intrinsics.segment<2>(2);
  Eigen::Matrix<double, 2, 3> by_local;
  by_local << Eigen::Matrix2d::Identity(), -*straight;
  by_local /= local.z();
  result.by_point =
      focal.asDiagonal() * distortion_slope(intrinsics, *straight) * by_local * rotation;
  const double x = straight->x(), y = straight->y(), square = straight->squaredNorm();
  Eigen::Matrix<double, 2, 5> by_distortion;  // k1, k2, p1, p2, k3
  by_distortion.col(0) = square * *straight;
  by_distortion.col(1) = square * square * *straight;
  by_distortion.col(2) << 2 * x * y, square + 2 * y * y;
  by_distortion.col(3) << square + 2 * x * x, 2 * x * y;
  by_distortion.col(4) = square * square * square * *straight;
  result.by_intrinsics << Eigen::Matrix2d(bent.asDiagonal()), Eigen::Matrix2d::Identity(),
      focal.asDiagonal() * by_distortion;
  return result;
}

std::optional<Eigen::Vector2d> CameraModel::straight(const Eigen::Vector2d& pixel) const {
  constexpr int kRounds = 30;
  constexpr double kMissed = 1e-12;
  const Eigen::Vector2d bent =
      (pixel - intrinsics.segment<2>(2)).cwiseQuotient(intrinsics.head<2>());
  Eigen::Vector2d place = bent;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector2d missed = distorted(intrinsics.data(), place) - bent;
    if (missed.norm() < kMissed) {
      return is_before_fold(intrinsics, place.squaredNorm()) ? std::optional(place) : std::nullopt;
    }
    place -= distortion_slope(intrinsics, place).partialPivLu().solve(missed);
    if (!place.allFinite()) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<SightRay> CameraModel::ray(const Eigen::Vector2d& pixel) const {
  const auto place = straight(pixel);
  if (!place) return std::nullopt;
  return SightRay{centre(), (pose.matrix().transpose() * place->homogeneous()).normalized()};
}

Eigen::Vector3d CameraModel::centre() const {
  return -(pose.matrix().transpose() * pose.translation);
}

}  // namespace pliant
