#include "pliant/material/component_law.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/density/dahl_constant_slope.h"

namespace pliant {

Eigen::VectorXd ComponentLaw::parameters() const {
  Eigen::VectorXd all(parameter_count());
  for (int i = 0; i < stiffness.size(); ++i) all(i) = stiffness.values()[static_cast<size_t>(i)];
  for (int i = 0; i < friction_count(); ++i) {
    all(stiffness.size() + i) = friction[static_cast<size_t>(i)];
  }
  return all;
}

ComponentLaw ComponentLaw::with_parameters(const Eigen::VectorXd& parameters) const {
  PLIANT_ASSERT(parameters.size() >= parameter_count(), "one value for each parameter of the law");
  ComponentLaw other = *this;
  other.stiffness = stiffness.with_values(parameters.data());
  for (int i = 0; i < friction_count(); ++i) {
    other.friction[static_cast<size_t>(i)] = parameters(stiffness.size() + i);
  }
  return other;
}

double ComponentLaw::elastic_tangent(double strain) const {
  return stiffness.value(strain) + stiffness.slope(strain) * strain;
}

double ComponentLaw::max_friction(double strain) const {
  if (friction_law == FrictionLaw::none) return 0;
  return friction[0] + friction[1] * std::abs(strain);
}

FrictionStress ComponentLaw::friction_stress(double strain, const FrictionState& from) const {
  switch (friction_law) {
    case FrictionLaw::none:
      return {};
    case FrictionLaw::dahl:
      return pliant::friction_stress(DahlParameters{friction[0], friction[1], friction[2]}, strain,
                                     from);
    case FrictionLaw::constant_slope:
      return pliant::friction_stress(ConstantSlopeParameters{friction[0], friction[1], friction[2]},
                                     strain, from);
  }
  return {};
}

std::vector<std::string> parameter_names(const ComponentLaw& law, const std::string& component) {
  std::vector<std::string> names;
  switch (law.stiffness.kind()) {
    case CurveKind::constant:
      names = {component + ".k"};
      break;
    case CurveKind::affine:
      names = {component + ".k1", component + ".k2"};
      break;
    case CurveKind::hermite:
      for (int i = 0; i < law.stiffness.size(); ++i) {
        names.push_back(component + ".k[" + std::to_string(i) + "]");
      }
      break;
  }
  if (law.friction_law == FrictionLaw::none) return names;
  const char* third = law.friction_law == FrictionLaw::dahl ? ".friction.tau" : ".friction.alpha";
  for (const char* name : {".friction.a", ".friction.b", third}) names.push_back(component + name);
  return names;
}

std::vector<std::string> parameter_units(const ComponentLaw& law, bool bending) {
  const std::string stiffness = bending ? "N m" : "N/m";
  std::vector<std::string> units(static_cast<size_t>(law.stiffness.size()), stiffness);
  if (law.stiffness.kind() == CurveKind::affine && bending) units[1] = "N m^2";
  if (law.friction_law == FrictionLaw::none) return units;
  const bool slope = law.friction_law == FrictionLaw::constant_slope;
  units.insert(units.end(),
               {bending ? "N" : "N/m", stiffness, slope ? stiffness : (bending ? "1/m" : "1")});
  return units;
}

}  // namespace pliant
