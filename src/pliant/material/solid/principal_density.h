#pragma once

#include <memory>

#include "pliant/material/solid/metric_jet.h"
#include "pliant/material/solid/principal_metric.h"

namespace pliant {

/// Isotropic elasticity by one law of one strain on each of the three principal stretches
/// ([Ogden1972]): energy psi(1) + psi(2) + psi(3).
///
/// The law must remember nothing: which stretch is which changes where two pass each other.
class PrincipalDensity : public ParametricDensity {
 public:
  /// @param law  of one strain, without history
  PrincipalDensity(const PrincipalMetric& metric, std::shared_ptr<const ParametricDensity> law);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override { return law_->parameters(); }
  bool is_linear() const override { return law_->is_linear(); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  const PrincipalMetric* metric_;
  std::shared_ptr<const ParametricDensity> law_;
};

}  // namespace pliant
