#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "pliant/estimation/statistics/covariance.h"

namespace pliant {

/// How well a number is known that follows from the unknowns of a fit, in its unit.
struct CurveError {
  double std_error = 0;
  double half_width = 0;  ///< of the 95 % interval
};

/// The error of something with these derivatives by the parameters of a law; nothing where the data
/// does not see it.
using ErrorOfLaw = std::function<std::optional<CurveError>(const Eigen::VectorXd& by_law)>;

/// The error of a curve at one of its points.
///
/// sqrt(d^T C d), d being the curve's derivatives by the unknowns; the interval is that times
/// Student's quantile. Degrees of freedom are those of the unknowns, averaged (harmonically) over
/// what each adds to the error.
/// @param gradient  derivatives by the unknowns
/// @param unit      of each unknown, as it was given to `parameter_errors`
/// @return nothing where the point depends on a direction that the data does not see
std::optional<CurveError> curve_error(const Eigen::VectorXd& gradient,
                                      const ParameterErrors& errors, const Eigen::VectorXd& unit);

}  // namespace pliant
