#include "pliant/experiment/buckling/clamped_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr double kJustBuckled = 0.998;  // distance at which it begins, of the length

}  // namespace

double half_rise(double length, double distance) {
  return std::sqrt(std::max(length * (length - distance), 0.0)) / std::numbers::pi;
}

ClampedStrip::ClampedStrip(const ComponentLaw& law, double weight, double length, BucklingSide side,
                           int elements)
    : law_(law),
      weight_(weight),
      length_(length),
      half_(length / 2, elements),
      history_(half_.rested(law)),
      distance_(kJustBuckled * length) {
  const double wave = 2 * std::numbers::pi / length;
  const double rise = half_rise(length, distance_) * (side == BucklingSide::up ? 1 : -1);
  shape_.curvature = rise * wave * wave * (wave * half_.line().places().array()).cos();
}

bool ClampedStrip::move_to(double distance, bool with_derivatives) {
  constexpr int kFirstSteps = 8;
  const double first_rise = std::sqrt(length_ - distance_);
  const double last_rise = std::sqrt(length_ - distance);
  for (int i = 1; !moved_ && i < kFirstSteps; ++i) {
    const double rise = first_rise + i * (last_rise - first_rise) / kFirstSteps;
    if (!go_to(length_ - rise * rise, with_derivatives)) return false;
  }
  moved_ = true;
  return go_to(distance, with_derivatives);
}

// Where the strip does not follow, it goes by halves of the way.
bool ClampedStrip::go_to(double distance, bool with_derivatives) {
  constexpr int kMostHalvings = 6;
  double part = 1;
  const double from = distance_;
  for (double done = 0; done < 1;) {
    const double there = from + std::min(done + part, 1.0) * (distance - from);
    if (step_to(there, with_derivatives)) {
      done += part;
    } else {
      part /= 2;
      if (part < std::ldexp(1.0, -kMostHalvings)) return false;
    }
  }
  return true;
}

bool ClampedStrip::step_to(double distance, bool with_derivatives) {
  StripEnds ends;  // its far end is the middle: level, and free to rise
  ends.far_angle = 0;
  ends.far_x = distance / 2;
  auto next = half_.equilibrium(law_, weight_, ends, history_, shape_);
  if (!next) return false;
  if (with_derivatives) half_.differentiate(law_, weight_, ends, history_, *next);
  history_ = half_.accepted(law_, history_, *next);
  shape_ = std::move(*next);
  distance_ = distance;
  return true;
}

}  // namespace pliant
