#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// The energy whose second derivative is linear between control points and constant beyond them
/// (a cubic spline, C2), zero with its slope at zero strain. What it is at a strain x is linear in
/// the control values: each function gives their weights.
///
/// It is convex over all strains exactly where no control value is negative.
/// @param knots  strictly increasing, at least one
/// @name Weights of the control values
/// @{
/// Of the second derivative.
Eigen::VectorXd spline_tangent_weights(const std::vector<double>& knots, double x);
/// Of the slope.
Eigen::VectorXd spline_stress_weights(const std::vector<double>& knots, double x);
/// Of the energy.
Eigen::VectorXd spline_energy_weights(const std::vector<double>& knots, double x);
/// Of the slope over the strain, with its limit at zero: the stiffness.
Eigen::VectorXd spline_secant_weights(const std::vector<double>& knots, double x);
/// Of the derivative of that.
Eigen::VectorXd spline_secant_slope_weights(const std::vector<double>& knots, double x);
/// @}

}  // namespace pliant
