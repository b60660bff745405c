#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// Forces on points that do not depend on where these are: gravity, cords that pull with a known
/// force ([T] 3.4.1).
class PointForces : public Potential {
 public:
  /// @param forces  N, one column a point
  explicit PointForces(Eigen::Matrix3Xd forces) : forces_(std::move(forces)) {}
  /// A force that comes from outside: each point feels its share of it.
  /// @param control  the number of the force among the vectors of the controls; not there: no force
  /// @param shares   one a point
  PointForces(int control, const Eigen::VectorXd& shares)
      : shares_(shares.transpose()), control_(control) {}

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;
  double outside_work(const Evaluation& at, const Configuration& from,
                      const Controls& before) const override {
    return control_ < 0 ? 0 : energy_by_controls(*this, from, before, at.controls);
  }

 private:
  void add(const Eigen::Matrix3Xd& forces, const Evaluation& at, Derivatives& derivatives) const;

  Eigen::Matrix3Xd forces_;    // where they are constant
  Eigen::RowVectorXd shares_;  // where they come from outside
  int control_ = -1;
};

}  // namespace pliant
