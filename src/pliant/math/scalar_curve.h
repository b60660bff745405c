#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// How a scalar curve interpolates its control values.
enum class CurveKind {
  none,      ///< zero everywhere, without control values
  constant,  ///< one value everywhere
  affine,    ///< values {k1, k2}: k1 + k2 |x| ([T] 5.3.2)
  hermite,   ///< piecewise cubic through (knots, values), constant outside ([T] 3.3)
  spline,    ///< secant x -> stress / x of the energy whose second derivative is linear between
             ///< (knots, values) and constant outside (tangent_spline.h)
  energy,    ///< secant of the energy that is piecewise cubic through (knots, values) and zero at
             ///< rest ([T] 4.2.2, hermite_energy.h)
};

std::string_view name_of(CurveKind kind);

/// A scalar function of one variable that is linear in its control values.
///
/// Linearity is what estimation needs: the value, the slope and the integrals at x are dot products
/// of the control values with weights that depend on x alone (`weights`, `slope_weights`, ...).
/// Hermite tangents are central differences of the neighbouring control points, one-sided at the
/// ends; a curve of |x| is level at a control point at 0, where it is mirrored.
class ScalarCurve {
 public:
  static ScalarCurve none();
  static ScalarCurve constant(double value);
  static ScalarCurve affine(double k1, double k2);

  /// @param knots   strictly increasing, at least one
  /// @param values  as many as knots
  /// @param even    the curve is a function of |x|; needs knots that start at 0
  /// @throws AssertionError when the sizes differ, the knots do not increase or an even curve has
  /// negative knots
  static ScalarCurve hermite(std::vector<double> knots, std::vector<double> values,
                             bool even = false);

  /// @param knots   strictly increasing, at least one
  /// @param values  second derivatives of the energy there
  /// @param even    the energy is one of |x|; needs knots that are not negative
  static ScalarCurve spline(std::vector<double> knots, std::vector<double> values,
                            bool even = false);

  /// @param knots   strictly increasing, none of them 0, at least one
  /// @param values  energies there
  /// @param even    the energy is one of |x|; needs knots that are positive
  static ScalarCurve energy(std::vector<double> knots, std::vector<double> values,
                            bool even = false);

  CurveKind kind() const { return kind_; }
  /// Whether it has control points.
  bool has_knots() const { return kind_ == CurveKind::hermite || is_of_energy(); }
  /// Whether its control values describe an energy.
  bool is_of_energy() const { return kind_ == CurveKind::spline || kind_ == CurveKind::energy; }
  bool even() const { return even_; }
  const std::vector<double>& knots() const { return knots_; }
  const std::vector<double>& values() const { return values_; }
  int size() const { return static_cast<int>(values_.size()); }

  /// The same curve with other control values (as many as `size()`).
  ScalarCurve with_values(const double* values) const;

  double value(double x) const;
  double slope(double x) const;
  /// Integral of the curve from 0 to x; not where it is of an energy.
  double integral(double x) const;
  /// Integral of curve(t) t dt from 0 to x: the energy of a stiffness curve at strain x.
  double first_moment(double x) const;

  /// d value / d control values at x: `size()` numbers.
  Eigen::VectorXd weights(double x) const;
  /// d slope / d control values at x.
  Eigen::VectorXd slope_weights(double x) const;
  /// d integral / d control values at x.
  Eigen::VectorXd integral_weights(double x) const;
  /// d first_moment / d control values at x.
  Eigen::VectorXd first_moment_weights(double x) const;

 private:
  double apply(const Eigen::VectorXd& weights) const;
  void update_tangents();
  double first_moment_from_front(double x) const;

  ScalarCurve(CurveKind kind, std::vector<double> knots, std::vector<double> values, bool even);

  CurveKind kind_;
  bool even_;
  std::vector<double> knots_;  // empty unless `has_knots`
  std::vector<double> values_;
  Eigen::MatrixXd tangents_;     // hermite: tangent at knot i = tangents_.row(i) . values
  Eigen::VectorXd slopes_;       // hermite: the tangents
  std::vector<double> moments_;  // hermite: integral of curve(t) t dt from the first knot to each
};

}  // namespace pliant
