#pragma once

#include "pliant/material/density/dahl_friction.h"

namespace pliant {

/// Dahl friction whose maximum grows with the logarithm of the rate of strain:
/// sigma_max = (a + b |strain|) (1 + growth ln(1 + rate / r0)), r0 = 1e-6 units of strain a second,
/// slower than which nothing is told apart. In statics, where steps have no end, it is Dahl
/// friction of (a, b, tau).
///
/// Dahl friction is homogeneous in its stress: what is followed is the stress over the factor. The
/// factor of a step is that of the rate of the step before; one that takes no time keeps it. With
/// its own, a step would have a potential too, but many short steps would not end where one long
/// step does.
///
/// History: the friction stress, and ln(1 + rate / r0) of the last step.
class RateFriction : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  /// @param values     a, b, tau, growth
  RateFriction(int component, const Eigen::Vector4d& values);

  int history_size() const override { return 2; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples&, Lane&) const override {}
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override { return values_; }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  int component_;
  Eigen::Vector4d values_;
  DahlFriction slowest_;
};

}  // namespace pliant
