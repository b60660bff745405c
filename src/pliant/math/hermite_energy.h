#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// The energy that goes through control values as a cubic Hermite spline ([T] 4.2.2). At zero
/// strain it is zero with its slope; at a control point its slope is that of the parabola through
/// the point and its neighbours, of which rest is one, at the last point through the three last.
/// Beyond its control points it goes on with the second derivative that it has there. A quadratic
/// energy is met exactly. What it is at a strain x is linear in the control values: each function
/// gives their weights.
///
/// Its second derivative is linear between control points and jumps at them.
/// @param knots  strictly increasing, none of them 0, at least one
/// @name Weights of the control values
/// @{
/// Of the second derivative.
Eigen::VectorXd hermite_energy_tangent_weights(const std::vector<double>& knots, double x);
/// Of the slope.
Eigen::VectorXd hermite_energy_stress_weights(const std::vector<double>& knots, double x);
/// Of the energy.
Eigen::VectorXd hermite_energy_weights(const std::vector<double>& knots, double x);
/// Of the slope over the strain, with its limit at zero: the stiffness.
Eigen::VectorXd hermite_energy_secant_weights(const std::vector<double>& knots, double x);
/// Of the derivative of that.
Eigen::VectorXd hermite_energy_secant_slope_weights(const std::vector<double>& knots, double x);
/// @}

/// Rows A: the energy of control values v is convex over all strains exactly where A v >= 0, the
/// second derivatives at both ends of each piece.
Eigen::MatrixXd hermite_energy_curvatures(const std::vector<double>& knots);

}  // namespace pliant
