#pragma once

#include "pliant/material/density/density.h"
#include "pliant/math/simd.h"

namespace pliant {

/// Eight vectors of space, one a lane.
struct LaneVector {
  Lane x, y, z;

  friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend LaneVector operator*(const Lane& f, const LaneVector& a) {
    return {f * a.x, f * a.y, f * a.z};
  }
};

inline Lane dot(const LaneVector& a, const LaneVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline LaneVector cross(const LaneVector& a, const LaneVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// As many of them as a processor takes at once.
template <class V>
struct WideVector {
  V x, y, z;
};

/// Those of the lanes from `first` on.
template <class V>
PLIANT_INLINE WideVector<V> load(const LaneVector& from, int first) {
  return {simd::load<V>(from.x.data() + first), simd::load<V>(from.y.data() + first),
          simd::load<V>(from.z.data() + first)};
}

template <class V>
PLIANT_INLINE void store(const WideVector<V>& v, int first, LaneVector& to) {
  simd::store(v.x, to.x.data() + first);
  simd::store(v.y, to.y.data() + first);
  simd::store(v.z, to.z.data() + first);
}

template <class V>
PLIANT_INLINE WideVector<V> operator+(const WideVector<V>& a, const WideVector<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class V>
PLIANT_INLINE WideVector<V> operator-(const WideVector<V>& a, const WideVector<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class V>
PLIANT_INLINE WideVector<V> operator*(const V& f, const WideVector<V>& a) {
  return {f * a.x, f * a.y, f * a.z};
}

template <class V>
PLIANT_INLINE V dot(const WideVector<V>& a, const WideVector<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class V>
PLIANT_INLINE WideVector<V> cross(const WideVector<V>& a, const WideVector<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace pliant
