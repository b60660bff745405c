#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// Quadratic pull of points towards targets: sum of stiffness / 2 |position - target|^2. A time
/// step's inertia (stiffness = mass / time^2) and drag (coefficient / time) are such.
class PointTargets : public Potential {
 public:
  /// What its energy counts as.
  enum class Kind { stored, work };

  /// @param stiffness  N/m, one a point, >= 0
  /// @param targets    m, one column a point
  PointTargets(Eigen::VectorXd stiffness, Eigen::Matrix3Xd targets, Kind kind);

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

 private:
  Eigen::VectorXd stiffness_;
  Eigen::Matrix3Xd targets_;
  Kind kind_;
};

}  // namespace pliant
