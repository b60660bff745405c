#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/homogeneous/homogeneous.h"
#include "pliant/experiment/homogeneous/homogeneous_point.h"
#include "pliant/material/solid/solid_density.h"

namespace pliant {

/// Predicts homogeneous tests with a solid whose numbers change.
class HomogeneousPredictor : public Predictor {
 public:
  /// @param experiment  outlives it
  HomogeneousPredictor(const HomogeneousTest& experiment, const Material& material);

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
               FrameSink& rows) override;
  /// Of any metric, whether the material has it or not.
  std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                              const Workers& workers) override;
  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) override;

 private:
  std::optional<std::vector<HomogeneousStress>> stresses(const Eigen::VectorXd& values,
                                                         bool derivatives,
                                                         const Workers& workers) const;

  const HomogeneousTest& experiment_;
  std::shared_ptr<const Sum> law_;
};

/// What a law answers along rows of which some begin at rest.
/// @return nothing where no equilibrium of the free sides is found
std::optional<std::vector<HomogeneousStress>> homogeneous_stresses(
    const ParametricDensity& law, const std::vector<HomogeneousRow>& rows,
    const std::vector<int>& beginnings, bool incompressible, bool derivatives);

}  // namespace pliant
