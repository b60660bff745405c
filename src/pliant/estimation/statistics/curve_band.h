#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/estimation/statistics/covariance.h"

namespace pliant {

/// Half width of the 95 % band of a curve at one of its points, in the unit of the curve.
///
/// sqrt(d^T C d) times Student's quantile, d being the curve's derivatives by the unknowns. Degrees
/// of freedom are those of the unknowns, averaged (harmonically) over what each adds to the band.
/// @param gradient  derivatives by the unknowns
/// @param unit      of each unknown, as it was given to `parameter_errors`
/// @return nothing where the point depends on a direction that the data does not see
std::optional<double> band_half_width(const Eigen::VectorXd& gradient,
                                      const ParameterErrors& errors, const Eigen::VectorXd& unit);

}  // namespace pliant
