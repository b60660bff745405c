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
    simd::run<Map>(positions.data(), this);
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
    simd::run<Stiffness>(this, response.stress.data(), response.tangent.data(), size.data(), convex,
                         result.data());
  }

  StvkMembrane::Positions at(int lane) const {
    StvkMembrane::Positions x;
    for (int k = 0; k < 9; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  // w_u and w_v.
  struct Map {
    template <class V>
    PLIANT_INLINE static void run(const double* positions, LaneKernel* kernel) {
      for (int l = 0; l < kLanes; l += simd::kWidth<V>) {
        WideVector<V> w_u{}, w_v{};
        for (int i = 0; i < 3; ++i) {
          const double* const x = positions + 3 * kLanes * i + l;
          const WideVector<V> node{simd::load<V>(x), simd::load<V>(x + kLanes),
                                   simd::load<V>(x + 2 * kLanes)};
          w_u = w_u + simd::load<V>(kernel->u_[i].data() + l) * node;
          w_v = w_v + simd::load<V>(kernel->v_[i].data() + l) * node;
        }
        store(w_u, l, kernel->w_u_);
        store(w_v, l, kernel->w_v_);
      }
    }
  };

  template <class V>
  struct Stress {
    V u, v, s;
  };

  struct Stiffness {
    template <class V>
    PLIANT_INLINE static void run(const LaneKernel* kernel, const double* stress,
                                  const double* tangent, const double* sizes, bool convex,
                                  double* result) {
      for (int l = 0; l < kLanes; l += simd::kWidth<V>) {
        Stress<V> y{simd::load<V>(stress + l), simd::load<V>(stress + kLanes + l),
                    simd::load<V>(stress + 2 * kLanes + l)};
        if (convex) make_convex(y);
        add_up(*kernel, y, tangent + l, simd::load<V>(sizes + l), l, result + l);
      }
    }

    template <class V>
    PLIANT_INLINE static void add_up(const LaneKernel& kernel, const Stress<V>& y,
                                     const double* tangent, const V& size, int l, double* result) {
      const auto t = [&](int i, int j) { return tangent + kLanes * (3 * i + j); };
      const V uu = size * simd::load<V>(t(0, 0)), vv = size * simd::load<V>(t(1, 1)),
              ss = size * simd::load<V>(t(2, 2)), uv = size * simd::load<V>(t(0, 1)),
              us = size * simd::load<V>(t(0, 2)), vs = size * simd::load<V>(t(1, 2));
      const V y_u = size * y.u, y_v = size * y.v, y_s = size * y.s;
      const WideVector<V> w_u = load<V>(kernel.w_u_, l), w_v = load<V>(kernel.w_v_, l);
      const V wu[3] = {w_u.x, w_u.y, w_u.z}, wv[3] = {w_v.x, w_v.y, w_v.z};
      V u[3], v[3];
      for (int i = 0; i < 3; ++i) {
        u[i] = simd::load<V>(kernel.u_[i].data() + l);
        v[i] = simd::load<V>(kernel.v_[i].data() + l);
      }
      for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
          const V p = wu[a] * wu[b], q = wu[a] * wv[b], r = wv[a] * wu[b], s = wv[a] * wv[b];
          V by_uu = uu * p + us * (q + r) + ss * s;
          V by_uv = uv * q + us * p + vs * s + ss * r;
          V by_vu = uv * r + us * p + vs * s + ss * q;
          V by_vv = vv * s + vs * (q + r) + ss * p;
          if (a == b) {
            by_uu += y_u;
            by_uv += y_s;
            by_vu += y_s;
            by_vv += y_v;
          }
          for (int i = 0; i < 3; ++i) {
            const V row_u = u[i] * by_uu + v[i] * by_vu, row_v = u[i] * by_uv + v[i] * by_vv;
            for (int j = i; j < 3; ++j) {
              simd::store(V(row_u * u[j] + row_v * v[j]),
                          result + kLanes * (9 * pair_number<StvkMembrane>(i, j) + 3 * b + a));
            }
          }
        }
      }
    }

    // The positive part of the stress matrix [u s; s v], as `positive_part` has it.
    template <class V>
    PLIANT_INLINE static void make_convex(Stress<V>& y) {
      const V zero{};
      const V mean = (y.u + y.v) / 2, half = (y.u - y.v) / 2;
      const V spread = simd::square_root(V(half * half + y.s * y.s));
      const V high = mean + spread, low = mean - spread;
      const auto positive = low >= zero;
      const V part = high > zero ? high / (2 * spread) : zero;
      const V scale = positive ? zero + 1 : part, shift = positive ? zero : low;
      y.u = scale * (y.u - shift);
      y.v = scale * (y.v - shift);
      y.s = scale * y.s;
    }
  };

  const LanePositions<StvkMembrane>& positions_;
  Lane u_[3], v_[3];  // the rest weights of the nodes
  LaneVector w_u_, w_v_;
};

}  // namespace pliant
