#pragma once

#include <memory>

#include "pliant/material/density/density.h"

namespace pliant {

/// The law of a sheet's point by one of a solid's: on the three strains (E_uu, E_vv, 2 E_uv) of a
/// sheet that keeps its thickness the other three of the solid's six are 0. So triangles take every
/// metric that solids do ([T] 4.2.1).
class InPlane : public ParametricDensity {
 public:
  /// @param of_solid  on the six strains of a solid's point (`kSolidStrains`)
  explicit InPlane(std::shared_ptr<const ParametricDensity> of_solid);

  int history_size() const override { return of_solid_->history_size(); }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override { return of_solid_->parameters(); }
  bool is_linear() const override { return of_solid_->is_linear(); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  std::shared_ptr<const ParametricDensity> of_solid_;
};

}  // namespace pliant
