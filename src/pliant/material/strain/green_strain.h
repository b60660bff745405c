#pragma once

#include <array>

#include <Eigen/LU>

#include "pliant/material/strain/inversion.h"
#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// Which two of the axes 0, 1, 2 at rest each of the six strains of a solid belongs to.
inline constexpr std::array<std::array<int, 2>, 6> kSolidStrainAxes{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// The strain of two axes at rest.
inline constexpr int kSolidStrainOf[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/// A point of a solid element at rest.
template <int Nodes>
struct SolidPointRest {
  /// Gradients of the nodes' shape functions in the rest shape: F = positions * weights (1/m).
  Eigen::Matrix<double, Nodes, 3> weights;
};

/// Green strain at one point of a solid element ([T] 4.2.1): E = (F^T F - I) / 2 as (E11, E22, E33,
/// 2 E23, 2 E13, 2 E12); the stress is the second Piola-Kirchhoff stress (S11, S22, S33, S23, S13,
/// S12). It is the same for an element that is turned inside out: nothing may pass through that, so
/// the measure also tells how far det F is from zero.
template <int Nodes>
struct GreenStrain : StrainTypes<Nodes, 6> {
  using Types = StrainTypes<Nodes, 6>;
  using typename Types::Gradient;
  using typename Types::Hessian;
  using typename Types::Positions;
  using typename Types::Strain;
  using Rest = SolidPointRest<Nodes>;

  static Strain strain(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix3d f = positions * rest.weights;
    Strain result;
    for (int v = 0; v < 6; ++v) {
      const auto [a, b] = kSolidStrainAxes[static_cast<size_t>(v)];
      result(v) = a == b ? (f.col(a).squaredNorm() - 1) / 2 : f.col(a).dot(f.col(b));
    }
    return result;
  }

  static Gradient gradient(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix3d f = positions * rest.weights;
    Gradient result;
    for (int i = 0; i < Nodes; ++i) {
      for (int v = 0; v < 6; ++v) {
        const auto [a, b] = kSolidStrainAxes[static_cast<size_t>(v)];
        Eigen::RowVector3d row = rest.weights(i, a) * f.col(b).transpose();
        if (a != b) row += rest.weights(i, b) * f.col(a).transpose();
        result.template block<1, 3>(v, 3 * i) = row;
      }
    }
    return result;
  }

  /// The strains are quadratic: their Hessians are multiples of the identity, block by block.
  static Hessian weighted_hessian(const Rest& rest, const Positions&, const Strain& y) {
    return spread(rest, stress_matrix(y));
  }

  static Hessian convex_weighted_hessian(const Rest& rest, const Positions&, const Strain& y) {
    return spread(rest, positive_part(stress_matrix(y)));
  }

  /// J = det F, the volume at the point over that at rest.
  static double volume_ratio(const Rest& rest, const Positions& positions) {
    return (positions * rest.weights).determinant();
  }

  /// The share of the straight ways of the nodes on all of which J stays above `kept` times its
  /// value at `from`.
  static double share_before_inversion(const Rest& rest, const Positions& from, const Positions& to,
                                       double kept) {
    return pliant::share_before_inversion(from * rest.weights, (to - from) * rest.weights, kept);
  }

 private:
  static Eigen::Matrix3d stress_matrix(const Strain& y) {
    Eigen::Matrix3d stress;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) stress(a, b) = y(kSolidStrainOf[a][b]);
    }
    return stress;
  }

  static Hessian spread(const Rest& rest, const Eigen::Matrix3d& stress) {
    const Eigen::Matrix<double, Nodes, Nodes> blocks =
        rest.weights * stress * rest.weights.transpose();
    Hessian result = Hessian::Zero();
    for (int i = 0; i < Nodes; ++i) {
      for (int j = 0; j < Nodes; ++j) {
        for (int k = 0; k < 3; ++k) result(3 * i + k, 3 * j + k) = blocks(i, j);
      }
    }
    return result;
  }
};

}  // namespace pliant
