#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// A spring and a dashpot in series on one strain component: its stress s follows
///
///     ds/dt = k d strain/dt - s / time,
///
/// so that what was strained relaxes. At a constant rate within a step of length h, with x =
/// exp(-h / time) and g = (1 - x) time / h, the step ends at s x + k g (strain - last): the
/// derivative of an incremental potential, quadratic and convex, that is exact for any h. A step
/// without end leaves no stress.
///
/// History: the stress.
class MaxwellDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  /// @param stiffness  k, of the spring (N/m for membranes, N m for bending), >= 0
  /// @param time       in which a held stress falls to 1/e (s), > 0
  MaxwellDensity(int component, double stiffness, double time);

  int history_size() const override { return 1; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  /// (stiffness, time).
  Eigen::VectorXd parameters() const override { return Eigen::Vector2d(stiffness_, time_); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  struct Step;

  Lane stored_at(const Lane& stress) const;

  int component_;
  double stiffness_, time_;
};

}  // namespace pliant
