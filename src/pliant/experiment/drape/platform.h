#pragma once

#include <vector>

#include "pliant/mechanics/potential.h"

namespace pliant {

/// A level platform that carries points without friction: a point of mass m that is d below it is
/// pushed up with m stiffness d, and one above it not at all.
class Platform : public Potential {
 public:
  /// @param height     the number of the vector of the controls whose z is the platform's (m); not
  ///                   there: there is no platform
  /// @param masses     of the points (kg)
  /// @param stiffness  per mass (1/s^2): under its own weight a point sinks in by g / stiffness
  Platform(int height, Eigen::VectorXd masses, double stiffness)
      : height_(height), springs_(stiffness * std::move(masses)) {}

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

 private:
  int height_;
  Eigen::VectorXd springs_;  // N/m
};

}  // namespace pliant
