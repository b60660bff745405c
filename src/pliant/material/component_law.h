#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/addend/addend.h"
#include "pliant/material/density/dahl.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {

/// Parameterisations of internal friction ([T] Fig. 5.3).
enum class FrictionLaw {
  none,
  dahl,            ///< (a, b, tau): maximum stress linear in strain, constant tau ([T] Eq. 5.2)
  constant_slope,  ///< (a, b, alpha): maximum stress linear in strain, constant alpha ([T] Eq. 5.1)
};

/// The one-dimensional law of one strain component: elastic stress k(strain) strain, friction, and
/// further laws that add to them.
///
/// Its parameters are numbered: first the control values of the stiffness, then the three of
/// friction, then those of the addends. Its elastic part is the stiffness with the addends that
/// remember nothing.
struct ComponentLaw {
  ScalarCurve stiffness = ScalarCurve::constant(0);
  FrictionLaw friction_law = FrictionLaw::none;
  std::array<double, 3> friction{};
  std::vector<Addend> addends = {};

  int friction_count() const { return friction_law == FrictionLaw::none ? 0 : 3; }
  int first_addend_parameter() const { return stiffness.size() + friction_count(); }
  int parameter_count() const;
  Eigen::VectorXd parameters() const;
  ComponentLaw with_parameters(const Eigen::VectorXd& parameters) const;
  /// Whether its stress hangs on more than the strain.
  bool remembers() const { return friction_law != FrictionLaw::none || addends_remember(); }
  bool addends_remember() const;
  /// Whether some of it depends on time.
  bool flows() const;
  /// How much the stress of friction and of addends that remember may fall per strain while the
  /// strain returns: the sum of their b.
  double fall() const;
  /// The same without friction and addends that remember.
  ComponentLaw elastic_part() const;
  /// The same without friction, that of addends included.
  ComponentLaw without_friction() const;

  double elastic_stress(double strain) const;
  /// d elastic stress / d strain; may be negative.
  double elastic_tangent(double strain) const;
  /// Integral of the elastic stress from 0 to a strain.
  double elastic_energy(double strain) const;
  /// Tangent with which the first step from rest begins, friction left out: that of the elastic
  /// stress and of elastic ranges.
  double stiffness_at_rest() const { return elastic_tangent(0) + range_stiffness(); }
  /// Of the elastic ranges of addends that remember and are no friction.
  double range_stiffness() const;
  /// Elastic stress over strain; at zero the tangent.
  double elastic_secant(double strain) const;
  /// d elastic stress / d parameters; zero for those of friction and of addends that remember.
  Eigen::VectorXd elastic_gradient(double strain) const;
  /// Adds it to the first numbers of a gradient.
  void add_elastic_gradient(double strain, Eigen::VectorXd& gradient) const;
  double max_friction(double strain) const;
  /// Friction stress along one monotone stretch from `from`; zero where there is no friction.
  FrictionStress friction_stress(double strain, const FrictionState& from) const;
};

/// Names of the parameters of a law: `stretch.warp.k1`, `stretch.warp.k[2]`,
/// `stretch.warp.friction.tau`.
std::vector<std::string> parameter_names(const ComponentLaw& law, const std::string& component);

/// Units of the parameters, e.g. N/m, 1 (dimensionless).
std::vector<std::string> parameter_units(const ComponentLaw& law, LawUnits units);

}  // namespace pliant
