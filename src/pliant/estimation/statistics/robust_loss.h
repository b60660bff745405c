#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace pliant {

/// How a residual counts.
enum class RobustLoss {
  none,    ///< squared
  huber,   ///< squared up to 1.345 sd, then straight: 95 % efficient for normal noise ([Huber1981])
  cauchy,  ///< logarithmic beyond about 2.385 sd: 95 % efficient likewise
};

/// What a squared residual s (in units of sd^2) counts, in the convention of Ceres: the cost is
/// half the sum of rho(s); rho(s) = s near 0.
double rho(RobustLoss loss, double squared);

/// d rho / d s: the weight of the row, 1 near 0, falling with s.
double robust_weight(RobustLoss loss, double squared);

/// Distance in sd at which a loss begins to differ from squares; what Ceres' losses are made with.
/// Infinite for `none`.
double loss_scale(RobustLoss loss);

/// The standard deviation that normal residuals of this median size would have; 0 for none.
double robust_sd(const Eigen::VectorXd& residual);

/// Residuals beyond three robust standard deviations are moved to there: what is told of the noise
/// of the others hardly changes (0.5 % of normal noise).
Eigen::VectorXd tamed(const Eigen::VectorXd& residual);

/// "none", "huber", "cauchy".
std::string_view name_of(RobustLoss loss);
std::optional<RobustLoss> robust_loss_named(std::string_view name);

}  // namespace pliant
