#include "pliant/capture/triangulation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace pliant {
namespace {

std::optional<Eigen::Vector3d> nearest_to_rays(const std::vector<Sighting>& sightings) {
  constexpr double kParallel = 1e-8;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Sighting& sighting : sightings) {
    const auto ray = sighting.camera->ray(sighting.pixel);
    if (!ray) return std::nullopt;
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray->direction * ray->direction.transpose();
    sum += across;
    right += across * ray->from;
  }
  if (!(sum.determinant() > kParallel)) return std::nullopt;
  return sum.ldlt().solve(right);
}

}  // namespace

std::optional<TriangulatedPoint> triangulate(const std::vector<Sighting>& sightings) {
  if (sightings.size() < 2) return std::nullopt;
  const auto start = nearest_to_rays(sightings);
  if (!start) return std::nullopt;
  TriangulatedPoint result{*start, Eigen::Matrix3d::Zero(), 0};
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    result.chi_square = 0;
    for (const Sighting& sighting : sightings) {
      const auto seen = sighting.camera->project_with_derivatives(result.point);
      if (!seen) return std::nullopt;
      const Eigen::Vector2d missed = (sighting.pixel - seen->pixel) / sighting.noise;
      const Eigen::Matrix<double, 2, 3> slope = seen->by_point / sighting.noise;
      normal += slope.transpose() * slope;
      right += slope.transpose() * missed;
      result.chi_square += missed.squaredNorm();
    }
    result.covariance = normal.inverse();
    if (round + 1 < kRounds) result.point += result.covariance * right;
  }
  if (!result.covariance.allFinite()) return std::nullopt;
  return result;
}

}  // namespace pliant
