#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace pliant {

/// What points span, along the axes, and what their straight ways span: in single precision, which
/// a search that asks for candidates makes up for by its reach (`rounding_of`).
class SweptBox {
 public:
  SweptBox() = default;
  /// Of one point.
  SweptBox(const Eigen::Vector3d& position, const Eigen::Vector3d& way)
      : low_(quad(position)), high_(low_), least_way_(quad(way)), most_way_(least_way_) {}

  void include(const SweptBox& other) {
    low_ = smaller(low_, other.low_);
    high_ = larger(high_, other.high_);
    least_way_ = smaller(least_way_, other.least_way_);
    most_way_ = larger(most_way_, other.most_way_);
  }

  /// Whether points within two boxes may come as near as `reach` along an axis while all go their
  /// ways at once: one, seen from the other, goes a way between the differences of theirs.
  static bool may_meet(const SweptBox& one, const SweptBox& other, float reach) {
    const Quad zero{};
    const Quad back = smaller(one.least_way_ - other.most_way_, zero) - reach;
    const Quad forth = larger(one.most_way_ - other.least_way_, zero) + reach;
    const auto apart = (one.low_ + back > other.high_) | (one.high_ + forth < other.low_);
    return (apart[0] | apart[1] | apart[2]) == 0;
  }

  double volume() const {
    const Quad size = high_ - low_;
    return static_cast<double>(size[0]) * static_cast<double>(size[1]) *
           static_cast<double>(size[2]);
  }

 private:
  // Three numbers and a zero, which the compiler keeps in one register.
  using Quad = float __attribute__((vector_size(16)));

  static Quad quad(const Eigen::Vector3d& x) {
    return Quad{static_cast<float>(x(0)), static_cast<float>(x(1)), static_cast<float>(x(2)), 0};
  }
  static Quad smaller(const Quad& a, const Quad& b) { return a < b ? a : b; }
  static Quad larger(const Quad& a, const Quad& b) { return a > b ? a : b; }

  Quad low_, high_, least_way_, most_way_;
};

/// By how much single precision may move the sides of boxes of points and their ways (m).
inline double rounding_of(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways) {
  constexpr double kUlps = 8;
  const double largest = positions.cwiseAbs().maxCoeff() + ways.cwiseAbs().maxCoeff();
  return kUlps * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest;
}

}  // namespace pliant
