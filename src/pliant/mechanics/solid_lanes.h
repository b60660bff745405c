#pragma once

#include <algorithm>

#include "pliant/material/strain/green_strain.h"
#include "pliant/mechanics/lane_kernel.h"

namespace pliant {

/// Eight points of solid elements at once. With S the second Piola-Kirchhoff stress and T = dS/dE
/// the force on node i is F S w_i, w_i being its row of the weights, and the stiffness between
/// nodes i and j the sum over axes a, b at rest of w_ia w_jb M_ab, M_ab = S_ab 1 + F D_ab F^T,
/// where D_ab(c, d) = T(ac, bd).
template <int Nodes>
class LaneKernel<GreenStrain<Nodes>> {
  using Measure = GreenStrain<Nodes>;

 public:
  LaneKernel(const typename Measure::Rest* rests, const LanePositions<Measure>& positions,
             bool /*differentiated*/ = true)
      : positions_(positions) {
    for (int a = 0; a < 3; ++a) {
      for (int i = 0; i < Nodes; ++i) {
        for (int l = 0; l < kLanes; ++l) weights_[i][a](l) = rests[l].weights(i, a);
      }
      for (int k = 0; k < 3; ++k) {
        f_[k][a] = positions.col(k) * weights_[0][a];
        for (int i = 1; i < Nodes; ++i) f_[k][a] += positions.col(3 * i + k) * weights_[i][a];
      }
    }
  }

  LaneStrains strain() const {
    LaneStrains result(kLanes, 6);
    for (int v = 0; v < 6; ++v) {
      const auto [a, b] = kSolidStrainAxes[static_cast<size_t>(v)];
      const Lane product = f_[0][a] * f_[0][b] + f_[1][a] * f_[1][b] + f_[2][a] * f_[2][b];
      result.col(v) = a == b ? Lane((product - 1) / 2) : product;
    }
    return result;
  }

  Lane volume_ratio() const {
    return f_[0][0] * (f_[1][1] * f_[2][2] - f_[1][2] * f_[2][1]) +
           f_[0][1] * (f_[1][2] * f_[2][0] - f_[1][0] * f_[2][2]) +
           f_[0][2] * (f_[1][0] * f_[2][1] - f_[1][1] * f_[2][0]);
  }

  void gradient(const Response& response, const Lane& size, LanePositions<Measure>& result) const {
    for (int k = 0; k < 3; ++k) {
      Lane p[3];  // a row of F S, times the size
      for (int b = 0; b < 3; ++b) {
        p[b] = size * (f_[k][0] * response.stress.col(kSolidStrainOf[0][b]) +
                       f_[k][1] * response.stress.col(kSolidStrainOf[1][b]) +
                       f_[k][2] * response.stress.col(kSolidStrainOf[2][b]));
      }
      for (int i = 0; i < Nodes; ++i) {
        result.col(3 * i + k) =
            p[0] * weights_[i][0] + p[1] * weights_[i][1] + p[2] * weights_[i][2];
      }
    }
  }

  void hessian(const Response& response, const Lane& size, bool convex,
               LaneHessian<Measure>& result) const {
    LaneStrains stress = response.stress;
    if (convex) make_convex(stress);
    Lane m[3][3][9];  // M_ab, column by column, times the size
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) {
        moduli(a, b, response, stress, m[a][b]);
        for (Lane& entry : m[a][b]) entry *= size;
        if (a == b) continue;
        for (int k = 0; k < 9; ++k) m[b][a][3 * (k % 3) + k / 3] = m[a][b][k];
      }
    }
    for (int i = 0; i < Nodes; ++i) {
      Lane rows[3][9];
      for (int b = 0; b < 3; ++b) {
        for (int k = 0; k < 9; ++k) {
          rows[b][k] = weights_[i][0] * m[0][b][k] + weights_[i][1] * m[1][b][k] +
                       weights_[i][2] * m[2][b][k];
        }
      }
      for (int j = i; j < Nodes; ++j) {
        const int first = 9 * pair_number<Measure>(i, j);
        for (int k = 0; k < 9; ++k) {
          result.col(first + k) = rows[0][k] * weights_[j][0] + rows[1][k] * weights_[j][1] +
                                  rows[2][k] * weights_[j][2];
        }
      }
    }
  }

  typename Measure::Positions at(int lane) const {
    typename Measure::Positions x;
    for (int k = 0; k < Measure::kUnknowns; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  // M_ab, column by column.
  void moduli(int a, int b, const Response& response, const LaneStrains& stress, Lane* m) const {
    const auto d = [&](int c, int e) {
      return response.tangent.col(6 * kSolidStrainOf[a][c] + kSolidStrainOf[b][e]);
    };
    for (int k = 0; k < 3; ++k) {
      Lane q[3];  // a row of F D_ab
      for (int e = 0; e < 3; ++e) {
        q[e] = f_[k][0] * d(0, e) + f_[k][1] * d(1, e) + f_[k][2] * d(2, e);
      }
      for (int l = 0; l < 3; ++l) {
        m[3 * l + k] = q[0] * f_[l][0] + q[1] * f_[l][1] + q[2] * f_[l][2];
      }
    }
    const auto s = stress.col(kSolidStrainOf[a][b]);
    for (int k = 0; k < 3; ++k) m[4 * k] += s;
  }

  static void make_convex(LaneStrains& stress) {
    for (int l = 0; l < kLanes; ++l) {
      Eigen::Matrix3d matrix;
      for (int k = 0; k < 9; ++k) matrix(k) = stress(l, kSolidStrainOf[k % 3][k / 3]);
      const Eigen::Matrix3d positive = positive_part(matrix);
      for (int v = 0; v < 6; ++v) {
        const auto [a, b] = kSolidStrainAxes[static_cast<size_t>(v)];
        stress(l, v) = positive(a, b);
      }
    }
  }

  const LanePositions<Measure>& positions_;
  Lane weights_[Nodes][3];
  Lane f_[3][3];
};

}  // namespace pliant
