#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// Strains of a point of a solid: the Green strain E = (F^T F - I) / 2 as the vector
/// (E11, E22, E33, 2 E23, 2 E13, 2 E12). The stress that belongs to it is the second
/// Piola-Kirchhoff stress (S11, S22, S33, S23, S13, S12), per rest volume (Pa).
inline constexpr int kSolidStrains = 6;

/// A scalar of the Green strain of eight material points with its first and second derivatives;
/// column 6 i + j of the Hessian is d2 / dE_i dE_j.
struct MetricJet {
  Lane value = Lane::Zero();
  Eigen::Array<double, kLanes, kSolidStrains> gradient = decltype(gradient)::Zero();
  Eigen::Array<double, kLanes, kSolidStrains* kSolidStrains> hessian = decltype(hessian)::Zero();

  /// Sets both entries of a symmetric pair.
  void set_hessian(int i, int j, const Lane& second) {
    hessian.col(kSolidStrains * i + j) = second;
    hessian.col(kSolidStrains * j + i) = second;
  }
};

/// f(x), by the value of f and its first two derivatives at x.
inline MetricJet composed(const MetricJet& x, const Lane& f, const Lane& f1, const Lane& f2) {
  MetricJet result;
  result.value = f;
  for (int i = 0; i < kSolidStrains; ++i) result.gradient.col(i) = f1 * x.gradient.col(i);
  for (int i = 0; i < kSolidStrains; ++i) {
    for (int j = i; j < kSolidStrains; ++j) {
      result.set_hessian(
          i, j,
          f1 * x.hessian.col(kSolidStrains * i + j) + f2 * x.gradient.col(i) * x.gradient.col(j));
    }
  }
  return result;
}

/// x y
inline MetricJet product(const MetricJet& x, const MetricJet& y) {
  MetricJet result;
  result.value = x.value * y.value;
  for (int i = 0; i < kSolidStrains; ++i) {
    result.gradient.col(i) = x.gradient.col(i) * y.value + x.value * y.gradient.col(i);
  }
  for (int i = 0; i < kSolidStrains; ++i) {
    for (int j = i; j < kSolidStrains; ++j) {
      const int k = kSolidStrains * i + j;
      result.set_hessian(i, j,
                         x.hessian.col(k) * y.value + x.value * y.hessian.col(k) +
                             x.gradient.col(i) * y.gradient.col(j) +
                             y.gradient.col(i) * x.gradient.col(j));
    }
  }
  return result;
}

}  // namespace pliant
