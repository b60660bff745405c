#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// Elasticity of one strain component whose rest is where strain has been furthest, as that of
/// fabrics which do not come back (permanent set):
///
///     stress = k (strain - m_above - m_below),
///
/// m_above >= 0 and m_below <= 0 the largest strains to either side. On the way there it has no
/// stress of its own, on the way back the slope k: with a stiffness h in parallel k / (h + k) of
/// the largest strain stays. It is an incremental potential of the new strain; where strain has
/// gone to both sides, moving the rest takes work.
///
/// History: m_above and m_below.
class SetDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  /// @param stiffness  k, N/m for membranes, N m for bending; >= 0
  SetDensity(int component, double stiffness);

  int history_size() const override { return 2; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  /// (stiffness).
  Eigen::VectorXd parameters() const override { return Eigen::VectorXd::Constant(1, stiffness_); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  struct Reach;

  Lane lost(const Samples& samples, const Reach& now) const;

  int component_;
  double stiffness_;
};

}  // namespace pliant
