#pragma once

#include "pliant/material/density/density.h"

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

}  // namespace pliant
