#pragma once

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Stress-strain curve of a law for figures and curves.csv: loading from rest to `largest_strain`,
/// unloading from there, and the 95 % band of the loading branch from the covariance of the law's
/// parameters.
/// @param covariance  of the law's parameters; may be empty (no band)
ComponentCurve component_curve(const std::string& component, const ComponentLaw& law,
                               double largest_strain, const Eigen::MatrixXd& covariance);

}  // namespace pliant
