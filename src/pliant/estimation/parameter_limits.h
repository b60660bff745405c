#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/study/study.h"

namespace pliant {

/// Names, units, bounds, scales and priors of all unknowns of a component fit, law first.
struct ParameterLimits {
  std::vector<std::string> names;
  std::vector<std::string> units;
  Eigen::VectorXd lower, upper, scale;
  std::vector<char> fixed;
  std::vector<std::optional<GaussianPrior>> priors;
  Eigen::MatrixXd not_negative;  ///< rows A with A parameters >= 0
};

/// Characteristic magnitudes of a component's data, from which bounds and scales follow.
struct DataScale {
  double stress = 1;
  double strain = 1;
};

/// The limits of a law's parameters and the given nuisance parameters, with the study's bounds,
/// fixed values and priors. Stiffnesses, a and b are not negative; tau lies between a thousandth of
/// the largest strain and three times it.
ParameterLimits parameter_limits(const ComponentLaw& shape, const std::string& component,
                                 const std::vector<NuisanceParameter>& nuisance,
                                 const DataScale& data, const FitOptions& options);

}  // namespace pliant
