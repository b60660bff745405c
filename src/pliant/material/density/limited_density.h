#pragma once

#include <memory>

#include "pliant/material/density/density.h"

namespace pliant {

/// A law whose energy psi stays below a largest one ([T] Eq. 4.5). A barrier m psi_max b(g) of the
/// share g = 1 - psi / psi_max that is left adds to it (`LimitBarrier`): its stress is the law's
/// own times lambda = m / g, so that lambda psi_max g = m psi_max. With m to zero lambda is the
/// multiplier of the complementarity problem psi <= psi_max, lambda >= 0, one of them an equality.
///
/// Its parameters are those of the law, then psi_max (J/m^3 or J/m^2). It acts on the strains of
/// points themselves: sums may hold it, other laws may not.
class LimitedDensity : public ParametricDensity {
 public:
  /// @param law     which remembers nothing; its energy is 0 at rest
  /// @param largest psi_max, above 0
  LimitedDensity(std::shared_ptr<const ParametricDensity> law, double largest);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  bool is_limited() const override { return true; }
  void lower_to_share_left(const Samples& samples, Lane& left) const override;
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override;
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  std::shared_ptr<const ParametricDensity> law_;
  double largest_;
};

}  // namespace pliant
