#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include "pliant/base/random.h"
#include "pliant/material/solid/metric_jet.h"
#include "pliant/material/solid/principal_stretches.h"

#include "support/density_samples.h"

namespace pliant::test {

/// The Green strain of a deformation gradient, as densities of solids take it.
inline SolidVector green_strain(const Eigen::Matrix3d& f) {
  const Eigen::Matrix3d e = (f.transpose() * f - Eigen::Matrix3d::Identity()) / 2;
  SolidVector strain;
  strain << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
  return strain;
}

inline Eigen::Matrix3d random_matrix(RandomStream& random, double reach) {
  Eigen::Matrix3d m;
  for (double& x : m.reshaped()) x = random.uniform(-reach, reach);
  return m;
}

/// A deformation with stretches between about 0.6 and 1.6 and no inversion.
inline Eigen::Matrix3d random_deformation(RandomStream& random) {
  for (;;) {
    const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + random_matrix(random, 0.35);
    if (f.determinant() > 0.3) return f;
  }
}

inline Eigen::Matrix3d random_rotation(RandomStream& random) {
  Eigen::Matrix3d q =
      Eigen::HouseholderQR<Eigen::Matrix3d>(random_matrix(random, 1)).householderQ();
  if (q.determinant() < 0) q.col(0) *= -1;
  return q;
}

/// The symmetric matrix of a stress (S11, S22, S33, S23, S13, S12).
inline Eigen::Matrix3d stress_matrix(const SolidVector& s) {
  Eigen::Matrix3d m;
  m << s(0), s(5), s(4), s(5), s(1), s(3), s(4), s(3), s(2);
  return m;
}

inline SolidVector stress_vector(const Eigen::Matrix3d& s) {
  SolidVector v;
  v << s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1);
  return v;
}

/// Eight times the same point, at rest before.
inline LaneState solid_point(const SolidVector& strain, int history_size = 0) {
  LaneState state(kSolidStrains, history_size);
  state.strain = strain.transpose().replicate(kLanes, 1).array();
  return state;
}

/// What a law answers at one strain.
struct SolidAnswer {
  double energy = 0;
  SolidVector stress;
  SolidMatrix tangent;
};

inline SolidAnswer answer(const Density& law, const SolidVector& strain) {
  const Response response = response_of(law, solid_point(strain, law.history_size()));
  SolidAnswer result;
  result.energy = response.stored(0) + response.work(0);
  result.stress = response.stress.row(0).transpose().matrix();
  for (int k = 0; k < 36; ++k) result.tangent(k / 6, k % 6) = response.tangent(0, k);
  return result;
}

}  // namespace pliant::test
