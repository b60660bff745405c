#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// Quadratic pull of points towards targets: sum of stiffness / 2 |position - target|^2. A time
/// step's inertia is such, with the stiffness mass / time^2.
class PointTargets : public Potential {
 public:
  /// @param stiffness  N/m, one a point, >= 0
  /// @param targets    m, one column a point
  PointTargets(Eigen::VectorXd stiffness, Eigen::Matrix3Xd targets);

  /// J, of points at `positions`.
  double energy(const Eigen::Matrix3Xd& positions) const;

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

 private:
  Eigen::VectorXd stiffness_;
  Eigen::Matrix3Xd targets_;
};

}  // namespace pliant
