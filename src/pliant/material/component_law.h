#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/density/dahl.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {

/// Parameterisations of internal friction ([T] Fig. 5.3).
enum class FrictionLaw {
  none,
  dahl,            ///< (a, b, tau): maximum stress linear in strain, constant tau ([T] Eq. 5.2)
  constant_slope,  ///< (a, b, alpha): maximum stress linear in strain, constant alpha ([T] Eq. 5.1)
};

/// The one-dimensional law of one strain component: elastic stress k(strain) strain plus friction.
///
/// Its parameters are numbered: first the control values of the stiffness, then the three of
/// friction.
struct ComponentLaw {
  ScalarCurve stiffness = ScalarCurve::constant(0);
  FrictionLaw friction_law = FrictionLaw::none;
  std::array<double, 3> friction{};

  int friction_count() const { return friction_law == FrictionLaw::none ? 0 : 3; }
  int parameter_count() const { return stiffness.size() + friction_count(); }
  Eigen::VectorXd parameters() const;
  ComponentLaw with_parameters(const Eigen::VectorXd& parameters) const;

  double elastic_stress(double strain) const { return stiffness.value(strain) * strain; }
  /// d elastic stress / d strain; may be negative.
  double elastic_tangent(double strain) const;
  double max_friction(double strain) const;
  /// Friction stress along one monotone stretch from `from`; zero where there is no friction.
  FrictionStress friction_stress(double strain, const FrictionState& from) const;
};

/// Names of the parameters of a law: `stretch.warp.k1`, `stretch.warp.k[2]`,
/// `stretch.warp.friction.tau`.
std::vector<std::string> parameter_names(const ComponentLaw& law, const std::string& component);

/// Units of the parameters, e.g. N/m, 1 (dimensionless): those of membrane components unless
/// `bending`.
std::vector<std::string> parameter_units(const ComponentLaw& law, bool bending);

}  // namespace pliant
