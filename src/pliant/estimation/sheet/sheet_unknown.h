#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/material.h"
#include "pliant/study/study.h"

namespace pliant {

/// Components that share one law: one in an orthotropic material, weft and warp in an isotropic
/// one. The first names them.
using ComponentGroup = std::vector<std::string>;

/// As good as no bound.
inline constexpr double kNoLimit = 1e12;

/// A number that a fit of sheets looks for: a parameter of the law of a group, or the friction of a
/// cord.
struct SheetUnknown {
  std::string name;                     ///< of the first component's parameter
  std::string owner;                    ///< the first component; the test of a cord
  std::string clip;                     ///< of a cord, else empty
  std::vector<std::string> parameters;  ///< of all components of the group
  std::string unit;
  double strain = 0;  ///< of a control point
  bool of_friction = false;
  double lower = 0, upper = 0, scale = 1;
  std::optional<GaussianPrior> prior;
  bool fixed = false;  ///< by the study; `lower` and `upper` are its value
};

/// The law that a group shares: that of its first component.
ComponentLaw law_of(const Material& material, const ComponentGroup& group);

/// Gives all components of a group a law.
void set_law(Material& material, const ComponentGroup& group, const ComponentLaw& law);

/// The parameters of some groups of a material, group by group: control values of the stiffness,
/// then those of friction. None is negative; tau lies between a thousandth of the largest strain
/// and three times it.
/// @param strains  largest strain of each group
/// @param cell     of the mesh (m), which limits springs that bend
std::vector<SheetUnknown> unknowns_of(const Material& material,
                                      const std::vector<ComponentGroup>& groups,
                                      const std::vector<double>& strains, double cell);

/// Their values.
Eigen::VectorXd values_of(const Material& material, const std::vector<ComponentGroup>& groups);

/// Gives the groups their values.
void set_values(Material& material, const std::vector<ComponentGroup>& groups,
                const Eigen::VectorXd& values);

}  // namespace pliant
