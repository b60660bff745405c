#pragma once

#include <memory>

#include "pliant/material/solid/metric.h"

namespace pliant {

/// The law of a solid's point by a law of one strain on a scalar of the Green strain: with the
/// scalar's gradient g and Hessian H the stress is psi' g and the tangent psi'' g g^T + psi' H.
/// What the law of one strain remembers, the point remembers.
class MetricDensity : public ParametricDensity {
 public:
  /// @param law  of one strain
  MetricDensity(const StrainMetric& metric, std::shared_ptr<const ParametricDensity> law);

  int history_size() const override { return law_->history_size(); }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override { return law_->parameters(); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, int lane, int first_history, int first_parameter,
                     SampleDerivatives& derivatives) const override;

 private:
  const StrainMetric* metric_;
  std::shared_ptr<const ParametricDensity> law_;
};

}  // namespace pliant
