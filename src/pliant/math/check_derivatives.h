#pragma once

#include <functional>
#include <string>

#include <Eigen/Core>

namespace pliant {

/// A vector-valued function of several variables.
using VectorFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Where a stated Jacobian is farthest from the one that finite differences give.
struct DerivativeCheck {
  /// |stated - estimated| of the worst entry times its argument's scale, as a share of what the
  /// value changes by over the scales of all arguments: a number without unit.
  double error = 0;
  Eigen::Index value = 0;     ///< row of the worst entry
  Eigen::Index argument = 0;  ///< its column
  double stated = 0;
  double estimated = 0;

  /// "d value[2] / d argument[0] is 3.1, differences say 3.0 (error 0.01)"
  std::string describe() const;
};

/// The Jacobian of a smooth function by central differences extrapolated to step zero (Ridders,
/// Advances in Engineering Software 4 (1982) 75). About 1e-10 of the values' change is its accuracy
/// where the function is smooth over a tenth of the scales.
/// @param scale  for each argument a change over which the function changes noticeably, > 0; steps
///               are at most a tenth of it
Eigen::MatrixXd estimate_jacobian(const VectorFunction& function, const Eigen::VectorXd& at,
                                  const Eigen::VectorXd& scale);

/// Compares a stated Jacobian with finite differences.
/// @param stated  d function / d arguments at `at`; a value that is not finite counts as infinitely
///                wrong
/// @throws AssertionError when the sizes do not fit
DerivativeCheck check_derivatives(const VectorFunction& function, const Eigen::MatrixXd& stated,
                                  const Eigen::VectorXd& at, const Eigen::VectorXd& scale);

}  // namespace pliant
