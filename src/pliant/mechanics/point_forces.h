#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// Constant forces on points: gravity, cords that pull with a known force ([T] 3.4.1).
class PointForces : public Potential {
 public:
  /// @param forces  N, one column a point
  explicit PointForces(Eigen::Matrix3Xd forces) : forces_(std::move(forces)) {}

  void set_forces(Eigen::Matrix3Xd forces) { forces_ = std::move(forces); }
  const Eigen::Matrix3Xd& forces() const { return forces_; }

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

 private:
  Eigen::Matrix3Xd forces_;
};

}  // namespace pliant
