#pragma once

#include "pliant/mechanics/state.h"

namespace pliant {

/// The way through a step of what is led from outside: at once where that is free, else bit by bit,
/// while the rest makes room.
class LedMotion {
 public:
  /// @param from  where the step begins
  /// @param to    the same, with what is led where the step ends
  LedMotion(const Configuration& from, const Configuration& to)
      : end_(to.positions), way_(to.positions - from.positions), left_(way_.isZero(0) ? 0 : 1) {}

  bool has_arrived() const { return left_ == 0; }

  /// What is left of the way; zero for what moves freely (m, one column a point). Empty where all
  /// has arrived.
  Eigen::Matrix3Xd way_left() const {
    return has_arrived() ? Eigen::Matrix3Xd() : Eigen::Matrix3Xd(left_ * way_);
  }

  /// Goes a share of what is left.
  void go(double share, Configuration& at) {
    if (has_arrived()) return;
    left_ = share == 1 ? 0 : left_ * (1 - share);
    const auto led = way_.array() != 0;
    at.positions = led.select(end_ - left_ * way_, at.positions);
  }

 private:
  Eigen::Matrix3Xd end_, way_;
  double left_;  // share of the way
};

}  // namespace pliant
