#pragma once

#include <cmath>

#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/lane_kernel.h"

namespace pliant {

/// Eight hinges at once; the formulas are those of DiscreteShells. The exact Hessian goes hinge by
/// hinge: statics asks for it, and there the factorisation is the larger part.
template <>
class LaneKernel<DiscreteShells> {
 public:
  LaneKernel(const DiscreteShells::Rest* rests, const LanePositions<DiscreteShells>& positions)
      : rests_(rests), positions_(positions) {
    const auto node = [&](int i) -> LaneVector {
      return {positions.col(3 * i), positions.col(3 * i + 1), positions.col(3 * i + 2)};
    };
    const LaneVector edge = node(1) - node(0);
    const LaneVector side1 = node(2) - node(0), side2 = node(3) - node(0);
    const LaneVector n1 = cross(edge, side1), n2 = cross(side2, edge);
    const Lane square = dot(edge, edge);
    const Lane length = square.sqrt();
    const Lane share1 = dot(side1, edge) / square, share2 = dot(side2, edge) / square;
    Lane scale;
    for (int l = 0; l < kLanes; ++l) scale(l) = 3 / rests[l].height;
    const LaneVector g1 = Lane(-scale * length / dot(n1, n1)) * n1;
    const LaneVector g2 = Lane(-scale * length / dot(n2, n2)) * n2;
    gradient_[1] = Lane(-share1) * g1 - share2 * g2;
    gradient_[0] = Lane(share1 - 1) * g1 - Lane(1 - share2) * g2;
    gradient_[2] = g1;
    gradient_[3] = g2;
    sine_ = dot(cross(n1, n2), edge) / length;
    cosine_ = dot(n1, n2);
  }

  LaneStrains strain() const {
    LaneStrains result(kLanes, 1);
    for (int l = 0; l < kLanes; ++l) {
      const DiscreteShells::Rest& rest = rests_[l];
      const double angle = continued_angle(std::atan2(sine_(l), cosine_(l)), rest.near_angle);
      result(l, 0) = 3 * (angle - rest.angle) / rest.height;
    }
    return result;
  }

  void gradient(const Response& response, const Lane& size,
                LanePositions<DiscreteShells>& result) const {
    const Lane stress = size * response.stress.col(0);
    for (int i = 0; i < 4; ++i) {
      result.col(3 * i) = stress * gradient_[i].x;
      result.col(3 * i + 1) = stress * gradient_[i].y;
      result.col(3 * i + 2) = stress * gradient_[i].z;
    }
  }

  void hessian(const Response& response, const Lane& size, bool convex,
               LaneHessian<DiscreteShells>& result) const {
    const Lane tangent = size * response.tangent.col(0);
    for (int i = 0; i < 4; ++i) {
      const LaneVector row = tangent * gradient_[i];
      for (int j = i; j < 4; ++j) {
        const LaneVector& column = gradient_[j];
        const Lane* const columns[3] = {&column.x, &column.y, &column.z};
        const int first = 9 * pair_number<DiscreteShells>(i, j);
        for (int b = 0; b < 3; ++b) {
          result.col(first + 3 * b) = row.x * *columns[b];
          result.col(first + 3 * b + 1) = row.y * *columns[b];
          result.col(first + 3 * b + 2) = row.z * *columns[b];
        }
      }
    }
    if (!convex) add_stress_part(response, size, result);
  }

  DiscreteShells::Positions at(int lane) const {
    DiscreteShells::Positions x;
    for (int k = 0; k < 12; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  void add_stress_part(const Response& response, const Lane& size,
                       LaneHessian<DiscreteShells>& result) const {
    for (int l = 0; l < kLanes; ++l) {
      const DiscreteShells::Strain stress(size(l) * response.stress(l, 0));
      const DiscreteShells::Hessian k = DiscreteShells::weighted_hessian(rests_[l], at(l), stress);
      int column = 0;
      for (const auto& [i, j] : node_pairs<DiscreteShells>()) {
        for (int b = 0; b < 3; ++b) {
          for (int a = 0; a < 3; ++a) result(l, column++) += k(3 * i + a, 3 * j + b);
        }
      }
    }
  }

  const DiscreteShells::Rest* rests_;
  const LanePositions<DiscreteShells>& positions_;
  LaneVector gradient_[4];  // of the strain, by node
  Lane sine_, cosine_;      // of the angle, times the product of the normals' lengths
};

}  // namespace pliant
