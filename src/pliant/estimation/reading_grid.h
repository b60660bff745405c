#pragma once

#include <optional>

#include <Eigen/Core>

namespace pliant {

/// The step of readings that stand on a grid so coarse that rounding to it makes half of a misfit
/// or more; nothing where they are finer, or on no grid.
/// @param misfit  root mean square, in the unit of the readings
std::optional<double> coarse_step(const Eigen::VectorXd& readings, double misfit);

}  // namespace pliant
