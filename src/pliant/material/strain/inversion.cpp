#include "pliant/material/strain/inversion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace pliant {
namespace {

// c0 + c1 s + c2 s^2 + c3 s^3.
struct Cubic {
  double c0, c1, c2, c3;

  double operator()(double s) const { return c0 + s * (c1 + s * (c2 + s * c3)); }
};

Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m) {
  Eigen::Matrix3d result;
  result.col(0) = m.col(1).cross(m.col(2));
  result.col(1) = m.col(2).cross(m.col(0));
  result.col(2) = m.col(0).cross(m.col(1));
  return result;
}

Cubic determinant_along(const Eigen::Matrix3d& from, const Eigen::Matrix3d& way) {
  return {from.determinant(), cofactors(from).cwiseProduct(way).sum(),
          cofactors(way).cwiseProduct(from).sum(), way.determinant()};
}

// The places in (0, 1) where a cubic turns, rising, and then 1.
std::array<double, 3> ends_of_monotone_parts(const Cubic& cubic) {
  std::array<double, 3> ends{1, 1, 1};
  const double a = 3 * cubic.c3, b = cubic.c2, c = cubic.c1;  // a s^2 + 2 b s + c
  const double inside = b * b - a * c;
  if (inside <= 0) return ends;
  const double q = -(b + std::copysign(std::sqrt(inside), b));
  size_t next = 0;
  for (const double root : {q / a, c / q}) {
    if (root > 0 && root < 1) ends[next++] = root;
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

// The last place of [low, high] before a falling function gets below a level.
double last_above(const Cubic& cubic, double level, double low, double high) {
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (cubic(middle) >= level ? low : high) = middle;
  }
  return low;
}

}  // namespace

double share_before_inversion(const Eigen::Matrix3d& from, const Eigen::Matrix3d& way,
                              double kept) {
  const Cubic cubic = determinant_along(from, way);
  if (!(cubic.c0 > 0)) return 0;
  const double level = kept * cubic.c0;
  if (std::abs(cubic.c1) + std::abs(cubic.c2) + std::abs(cubic.c3) < cubic.c0 - level) return 1;
  double begin = 0;
  for (const double end : ends_of_monotone_parts(cubic)) {
    if (!(cubic(end) >= level)) return last_above(cubic, level, begin, end);
    begin = end;
  }
  return 1;
}

Eigen::Matrix3d positive_part(const Eigen::Matrix3d& symmetric) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(symmetric);
  if (eigen.eigenvalues()(0) >= 0) return symmetric;
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace pliant
