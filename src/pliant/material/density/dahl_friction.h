#pragma once

#include "pliant/material/density/dahl.h"
#include "pliant/material/density/density.h"

namespace pliant {

/// Dahl friction on one strain component ([T] 5.2) as an incremental potential.
///
/// Within a step the friction stress is a function of the new strain alone, the exact solution of
/// [T] Eq. 5.2 from the last accepted strain: the loading branch above it, the unloading branch
/// below. It is the derivative of a potential whose second derivative is never below -b, where both
/// sides of zero are alike; no sign of the rate is guessed. The slope jumps at the last strain:
/// there it is the stiffer of the two, (sigma_max + |sigma|) / tau. For b = 0 no stretch from there
/// is stiffer, so that one linear system a step takes a reversal into account and need not guess
/// it.
///
/// History: the friction stress.
class DahlFriction : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  DahlFriction(int component, const DahlParameters& dahl);
  DahlFriction(int component, const DahlBySide& dahl);

  int history_size() const override { return 1; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples&, Lane&) const override {}
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  /// (a, b, tau), and those of negative strain where they differ.
  Eigen::VectorXd parameters() const override;
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  int component_;
  DahlBySide dahl_;
  bool by_side_;
};

}  // namespace pliant
