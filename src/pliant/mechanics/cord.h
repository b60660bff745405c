#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// An elastic cord between a point and an end that is moved from outside: it pulls with
/// stiffness * (distance - length) and never pushes.
class Cord : public Potential {
 public:
  /// @param stiffness  N/m, > 0
  /// @param length     of the slack cord (m), >= 0
  /// @param end        where it is fixed, m
  /// @param control    the number of its end among the vectors of the controls; -1: it stays
  Cord(int point, double stiffness, double length, const Eigen::Vector3d& end, int control = -1);

  int point() const { return point_; }
  /// Force on the point (N).
  Eigen::Vector3d force(const Configuration& configuration,
                        const Controls& controls = kNoControls) const;

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;
  double outside_work(const Evaluation& at, const Configuration& from,
                      const Controls& before) const override {
    return control_ < 0 ? 0 : energy_by_controls(*this, from, before, at.controls);
  }

 private:
  int point_;
  double stiffness_, length_;
  Eigen::Vector3d end_;
  int control_;
};

}  // namespace pliant
