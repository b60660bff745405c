#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/material.h"

namespace pliant {

/// Components that share one curve: one in an orthotropic material, weft and warp in an isotropic
/// one. The first names them.
using ComponentGroup = std::vector<std::string>;

/// A number that a fit of sheets looks for: a control value of the stiffness of a group.
struct SheetUnknown {
  std::string name;                     ///< of the first component's parameter
  std::vector<std::string> parameters;  ///< of all components of the group
  std::string unit;
  double strain = 0;  ///< of the control point
};

/// The control values of some groups of a material, group by group.
std::vector<SheetUnknown> unknowns_of(const Material& material,
                                      const std::vector<ComponentGroup>& groups);

/// Values of all parameters of the stiffness of a group's first component.
Eigen::VectorXd control_values(const Material& material, const ComponentGroup& group);

/// Gives all components of a group a curve.
void set_stiffness(Material& material, const ComponentGroup& group, const ScalarCurve& curve);

/// Gives the groups their control values, one after the other.
void set_values(Material& material, const std::vector<ComponentGroup>& groups,
                const Eigen::VectorXd& values);

}  // namespace pliant
