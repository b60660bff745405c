#pragma once

#include <memory>

#include "pliant/material/density/density.h"

namespace pliant {

/// A law of one strain on a sum of the strains of a material point, each times its weight w: the
/// stress is psi' w, the tangent psi'' w w^T. On the sum of both stretches of a sheet a quadratic
/// energy k / 2 (E_weft + E_warp)^2 has the cross term k E_weft E_warp of [T] Eq. 4.3, and is
/// convex.
class CombinedStrain : public ParametricDensity {
 public:
  /// @param weights  one a strain of the point
  /// @param law      of one strain
  CombinedStrain(Eigen::VectorXd weights, std::shared_ptr<const ParametricDensity> law);

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
  Eigen::VectorXd weights_;
  std::shared_ptr<const ParametricDensity> law_;
};

}  // namespace pliant
