#pragma once

#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/mechanics/lane_kernel.h"

namespace pliant {

/// Eight StVK triangles at once. With P_u = y_u w_u + y_s w_v and P_v = y_v w_v + y_s w_u the force
/// on node i is u_i P_u + v_i P_v, and the stiffness between nodes i and j
/// u_i u_j dP_u/dw_u + u_i v_j dP_u/dw_v + v_i u_j (dP_u/dw_v)^T + v_i v_j dP_v/dw_v.
template <>
class LaneKernel<StvkMembrane> {
 public:
  LaneKernel(const MembraneRest* rests, const LanePositions<StvkMembrane>& positions,
             bool /*differentiated*/ = true)
      : positions_(positions) {
    for (int l = 0; l < kLanes; ++l) {
      for (int i = 0; i < 3; ++i) {
        u_[i](l) = rests[l].weights(i, 0);
        v_[i](l) = rests[l].weights(i, 1);
      }
    }
    const auto map = [&](const Lane* weights, int axis) -> Lane {
      return weights[0] * positions.col(axis) + weights[1] * positions.col(3 + axis) +
             weights[2] * positions.col(6 + axis);
    };
    w_u_ = {map(u_, 0), map(u_, 1), map(u_, 2)};
    w_v_ = {map(v_, 0), map(v_, 1), map(v_, 2)};
  }

  LaneStrains strain() const {
    LaneStrains result(kLanes, 3);
    result.col(0) = (dot(w_u_, w_u_) - 1) / 2;
    result.col(1) = (dot(w_v_, w_v_) - 1) / 2;
    result.col(2) = dot(w_u_, w_v_);
    return result;
  }

  void gradient(const Response& response, const Lane& size,
                LanePositions<StvkMembrane>& result) const {
    const auto y = [&](int i) -> Lane { return size * response.stress.col(i); };
    const LaneVector p_u = y(0) * w_u_ + y(2) * w_v_, p_v = y(1) * w_v_ + y(2) * w_u_;
    for (int i = 0; i < 3; ++i) {
      const LaneVector force = u_[i] * p_u + v_[i] * p_v;
      result.col(3 * i) = force.x;
      result.col(3 * i + 1) = force.y;
      result.col(3 * i + 2) = force.z;
    }
  }

  void hessian(const Response& response, const Lane& size, bool convex,
               LaneHessian<StvkMembrane>& result) const {
    const Stress y = stress(response, size, convex);
    const auto t = [&](int i, int j) -> Lane { return size * response.tangent.col(3 * i + j); };
    const Lane uu = t(0, 0), vv = t(1, 1), ss = t(2, 2), uv = t(0, 1), us = t(0, 2), vs = t(1, 2);
    const Lane* const wu[3] = {&w_u_.x, &w_u_.y, &w_u_.z};
    const Lane* const wv[3] = {&w_v_.x, &w_v_.y, &w_v_.z};
    for (int b = 0; b < 3; ++b) {
      for (int a = 0; a < 3; ++a) {
        const Lane p = *wu[a] * *wu[b], q = *wu[a] * *wv[b], r = *wv[a] * *wu[b],
                   s = *wv[a] * *wv[b];
        Lane by_uu = uu * p + us * (q + r) + ss * s;
        Lane by_uv = uv * q + us * p + vs * s + ss * r;
        Lane by_vu = uv * r + us * p + vs * s + ss * q;
        Lane by_vv = vv * s + vs * (q + r) + ss * p;
        if (a == b) {
          by_uu += y.u;
          by_uv += y.s;
          by_vu += y.s;
          by_vv += y.v;
        }
        for (int i = 0; i < 3; ++i) {
          const Lane row_u = u_[i] * by_uu + v_[i] * by_vu, row_v = u_[i] * by_uv + v_[i] * by_vv;
          for (int j = i; j < 3; ++j) {
            result.col(9 * pair_number<StvkMembrane>(i, j) + 3 * b + a) =
                row_u * u_[j] + row_v * v_[j];
          }
        }
      }
    }
  }

  StvkMembrane::Positions at(int lane) const {
    StvkMembrane::Positions x;
    for (int k = 0; k < 9; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  struct Stress {
    Lane u, v, s;
  };

  static Stress stress(const Response& response, const Lane& size, bool convex) {
    Stress y{response.stress.col(0), response.stress.col(1), response.stress.col(2)};
    if (convex) make_convex(y);
    return {size * y.u, size * y.v, size * y.s};
  }

  // The positive part of the stress matrix [u s; s v], as `positive_part` has it.
  static void make_convex(Stress& y) {
    const Lane mean = (y.u + y.v) / 2, half = (y.u - y.v) / 2;
    const Lane spread = (half.square() + y.s.square()).sqrt();
    const Lane high = mean + spread, low = mean - spread;
    for (int l = 0; l < kLanes; ++l) {
      const bool positive = low(l) >= 0;
      const double scale = positive ? 1 : (high(l) <= 0 ? 0 : high(l) / (2 * spread(l)));
      const double shift = positive ? 0 : low(l);
      y.u(l) = scale * (y.u(l) - shift);
      y.v(l) = scale * (y.v(l) - shift);
      y.s(l) = scale * y.s(l);
    }
  }

  const LanePositions<StvkMembrane>& positions_;
  Lane u_[3], v_[3];  // the rest weights of the nodes
  LaneVector w_u_, w_v_;
};

}  // namespace pliant
