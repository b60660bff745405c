#include "pliant/material/component_law.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/density/dahl_constant_slope.h"

namespace pliant {

int ComponentLaw::parameter_count() const {
  int count = first_addend_parameter();
  for (const Addend& addend : addends) count += addend.size();
  return count;
}

Eigen::VectorXd ComponentLaw::parameters() const {
  Eigen::VectorXd all(parameter_count());
  for (int i = 0; i < stiffness.size(); ++i) all(i) = stiffness.values()[static_cast<size_t>(i)];
  for (int i = 0; i < friction_count(); ++i) {
    all(stiffness.size() + i) = friction[static_cast<size_t>(i)];
  }
  int next = first_addend_parameter();
  for (const Addend& addend : addends) {
    all.segment(next, addend.size()) = addend.values();
    next += addend.size();
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
  int next = first_addend_parameter();
  for (Addend& addend : other.addends) {
    addend = Addend(addend.kind(), parameters.segment(next, addend.size()));
    next += addend.size();
  }
  return other;
}

bool ComponentLaw::addends_remember() const {
  return std::ranges::any_of(addends, [](const Addend& addend) { return !addend.is_elastic(); });
}

bool ComponentLaw::flows() const {
  return std::ranges::any_of(addends, [](const Addend& addend) { return addend.flows(); });
}

double ComponentLaw::fall() const {
  double fall = friction_law == FrictionLaw::none ? 0 : friction[1];
  for (const Addend& addend : addends) fall += addend.fall();
  return fall;
}

ComponentLaw ComponentLaw::elastic_part() const {
  ComponentLaw elastic = *this;
  elastic.friction_law = FrictionLaw::none;
  std::erase_if(elastic.addends, [](const Addend& addend) { return !addend.is_elastic(); });
  return elastic;
}

ComponentLaw ComponentLaw::without_friction() const {
  ComponentLaw other = *this;
  other.friction_law = FrictionLaw::none;
  std::erase_if(other.addends, [](const Addend& addend) { return addend.is_friction(); });
  return other;
}

double ComponentLaw::range_stiffness() const {
  double stiffness = 0;
  for (const Addend& addend : addends) stiffness += addend.range_stiffness();
  return stiffness;
}

double ComponentLaw::elastic_stress(double strain) const {
  double stress = stiffness.value(strain) * strain;
  for (const Addend& addend : addends) {
    if (addend.is_elastic()) stress += addend.at(strain, strain, {}).stress;
  }
  return stress;
}

double ComponentLaw::elastic_tangent(double strain) const {
  double tangent = stiffness.value(strain) + stiffness.slope(strain) * strain;
  for (const Addend& addend : addends) {
    if (addend.is_elastic()) tangent += addend.at(strain, strain, {}).tangent;
  }
  return tangent;
}

double ComponentLaw::elastic_energy(double strain) const {
  double energy = stiffness.first_moment(strain);
  for (const Addend& addend : addends) {
    if (addend.is_elastic()) energy += addend.at(strain, strain, {}).stored;
  }
  return energy;
}

double ComponentLaw::elastic_secant(double strain) const {
  if (addends.empty()) return stiffness.value(strain);
  return strain == 0 ? elastic_tangent(0) : elastic_stress(strain) / strain;
}

Eigen::VectorXd ComponentLaw::elastic_gradient(double strain) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(parameter_count());
  add_elastic_gradient(strain, gradient);
  return gradient;
}

void ComponentLaw::add_elastic_gradient(double strain, Eigen::VectorXd& gradient) const {
  gradient.head(stiffness.size()) += strain * stiffness.weights(strain);
  int next = first_addend_parameter();
  for (const Addend& addend : addends) {
    if (addend.is_elastic()) {
      gradient.segment(next, addend.size()) +=
          addend.derivatives(strain, strain, {}).stress_by_parameter.row(0).transpose();
    }
    next += addend.size();
  }
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
    case CurveKind::none:
      break;
    case CurveKind::constant:
      names = {component + ".k"};
      break;
    case CurveKind::affine:
      names = {component + ".k1", component + ".k2"};
      break;
    case CurveKind::hermite:
    case CurveKind::spline:
      for (int i = 0; i < law.stiffness.size(); ++i) {
        names.push_back(component + ".k[" + std::to_string(i) + "]");
      }
      break;
    case CurveKind::energy:
      for (int i = 0; i < law.stiffness.size(); ++i) {
        names.push_back(component + ".psi[" + std::to_string(i) + "]");
      }
      break;
  }
  if (law.friction_law != FrictionLaw::none) {
    const char* third = law.friction_law == FrictionLaw::dahl ? ".friction.tau" : ".friction.alpha";
    for (const char* name : {".friction.a", ".friction.b", third}) {
      names.push_back(component + name);
    }
  }
  for (const std::string& name : parameter_names(law.addends)) {
    names.push_back(component + "." + name);
  }
  return names;
}

std::vector<std::string> parameter_units(const ComponentLaw& law, LawUnits system) {
  const bool bending = system == LawUnits::bending;
  const auto of_stiffness = [&]() -> std::string {
    switch (system) {
      case LawUnits::membrane:
        return "N/m";
      case LawUnits::bending:
        return "N m";
      case LawUnits::solid:
        return "Pa";
      case LawUnits::ratio:
        return "1";
    }
    return "";
  };
  const std::string stiffness = of_stiffness();
  std::vector<std::string> units(static_cast<size_t>(law.stiffness.size()), stiffness);
  if (law.stiffness.kind() == CurveKind::affine && bending) units[1] = "N m^2";
  if (law.stiffness.kind() == CurveKind::energy && bending) {
    std::ranges::fill(units, "N/m");
  }
  if (law.friction_law != FrictionLaw::none) {
    const bool slope = law.friction_law == FrictionLaw::constant_slope;
    units.insert(units.end(), {bending ? "N" : stiffness, stiffness,
                               slope ? stiffness : (bending ? "1/m" : "1")});
  }
  for (const Addend& addend : law.addends) {
    for (const AddendParameter& parameter : addend.kind().parameters) {
      units.push_back(unit_of(parameter, system));
    }
  }
  return units;
}

}  // namespace pliant
