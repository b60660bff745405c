#pragma once

#include <array>

#include <Eigen/Core>

namespace pliant {

using SolidVector = Eigen::Matrix<double, 6, 1>;
using SolidMatrix = Eigen::Matrix<double, 6, 6>;

/// The principal stretches of a point with Green strain E = sum_a strain_a n_a n_a^T.
class PrincipalStretches {
 public:
  /// @param green  (E11, E22, E33, 2 E23, 2 E13, 2 E12)
  explicit PrincipalStretches(const SolidVector& green);

  /// Squares of the stretches, increasing: eigenvalues of C.
  const Eigen::Vector3d& squares() const { return squares_; }
  /// Logarithms of the stretches.
  const Eigen::Vector3d& logs() const { return logs_; }

  /// The stress of a function of the logarithms of the stretches, which does not depend on their
  /// order.
  /// @param by_log  d energy / d log stretch
  SolidVector stress(const Eigen::Vector3d& by_log) const;

  /// Its derivative by the Green strain. Where stretches coincide the limit is taken: it is smooth
  /// there.
  /// @param second_by_log  second derivatives by the logarithms
  SolidMatrix tangent(const Eigen::Vector3d& by_log, const Eigen::Matrix3d& second_by_log) const;

 private:
  double turning_stiffness(int a, int b, const Eigen::Vector3d& stress,
                           const Eigen::Matrix3d& tangent) const;

  Eigen::Vector3d strains_, squares_, logs_;
  std::array<SolidVector, 3> along_;    // n_a n_a
  std::array<SolidVector, 3> between_;  // the symmetric part of n_a n_b, opposite a third
};

}  // namespace pliant
