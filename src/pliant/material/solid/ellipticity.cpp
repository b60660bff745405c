#include "pliant/material/solid/ellipticity.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "pliant/base/assert.h"
#include "pliant/material/strain/green_strain.h"

namespace pliant {
namespace {

constexpr int kDirections = 300;  // on half a sphere: 8 degrees apart
constexpr double kFirstTurn = 0.15, kLastTurn = 1e-5;

/// Directions of a spiral that cover half a sphere evenly.
Eigen::Vector3d direction(int number) {
  const double height = (number + 0.5) / kDirections;
  const double angle = 2 * std::numbers::pi * number / std::numbers::phi;
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

Eigen::Matrix3d acoustic_tensor(const DeformedPoint& point, const Eigen::Vector3d& n) {
  Eigen::Matrix3d moduli = Eigen::Matrix3d::Zero(), stress;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      stress(a, b) = point.stress(kSolidStrainOf[a][b]);
      for (int j = 0; j < 3; ++j) {
        for (int l = 0; l < 3; ++l) {
          moduli(a, b) += n(j) * n(l) * point.tangent(kSolidStrainOf[a][j], kSolidStrainOf[b][l]);
        }
      }
    }
  }
  const Eigen::Matrix3d& f = point.gradient;
  return n.dot(stress * n) * Eigen::Matrix3d::Identity() + f * moduli * f.transpose();
}

double least_modulus(const DeformedPoint& point, const Eigen::Vector3d& n, bool isochoric) {
  const Eigen::Matrix3d tensor = acoustic_tensor(point, n);
  if (!isochoric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly)
        .eigenvalues()(0);
  }
  const Eigen::Vector3d across = (point.gradient.inverse().transpose() * n).normalized();
  Eigen::Matrix<double, 3, 2> within;
  within.col(0) = across.unitOrthogonal();
  within.col(1) = across.cross(within.col(0));
  const Eigen::Matrix2d part = within.transpose() * tensor * within;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(part, Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

}  // namespace

DeformedPoint deformed_point(const Density& law, const Eigen::Matrix3d& gradient) {
  PLIANT_ASSERT(law.history_size() == 0, "waves of what remembers depend on more than the point");
  const Eigen::Matrix3d green = (gradient.transpose() * gradient - Eigen::Matrix3d::Identity()) / 2;
  Eigen::Array<double, kLanes, Eigen::Dynamic> numbers(kLanes, 6);
  for (int v = 0; v < 6; ++v) {
    const auto [a, b] = kSolidStrainAxes[static_cast<std::size_t>(v)];
    numbers.col(v) = a == b ? green(a, b) : 2 * green(a, b);
  }
  const LaneView strain(numbers.data(), kLanes, 6);
  Response response(6);
  law.add({strain, strain, strain, LaneView(numbers.data(), kLanes, 0)}, {}, response);
  DeformedPoint point{
      gradient, response.stored(0), response.stress.row(0).transpose().matrix(), {}};
  for (int k = 0; k < 36; ++k) point.tangent(k / 6, k % 6) = response.tangent(0, k);
  return point;
}

// The best of many directions, turned by ever smaller angles to where it is least.
double least_wave_modulus(const DeformedPoint& point, bool isochoric) {
  Eigen::Vector3d best = direction(0);
  double least = least_modulus(point, best, isochoric);
  const auto take = [&](const Eigen::Vector3d& n) {
    const double modulus = least_modulus(point, n, isochoric);
    if (!(modulus < least)) return false;
    least = modulus;
    best = n;
    return true;
  };
  for (int i = 1; i < kDirections; ++i) take(direction(i));
  for (const Eigen::Vector3d& axis : Eigen::Matrix3d::Identity().colwise()) take(axis);
  for (double turn = kFirstTurn; turn > kLastTurn;) {
    const Eigen::Vector3d first = best.unitOrthogonal(), second = best.cross(first), at = best;
    bool better = false;
    for (const auto& [a, b] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      better |= take((at + turn * (a * first + b * second)).normalized());
    }
    if (!better) turn /= 2;
  }
  return least;
}

}  // namespace pliant
