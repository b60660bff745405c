#pragma once

#include <Eigen/Core>

namespace pliant {

/// Gaussians of distances, of sum 1 ([T] 4.2.4).
/// @param squares  of the distances; at least one
/// @param width    standard deviation
Eigen::VectorXd gaussian_weights(const Eigen::VectorXd& squares, double width);

}  // namespace pliant
