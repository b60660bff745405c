#include "pliant/estimation/sheet/sheet_unknown.h"

#include "pliant/base/assert.h"

namespace pliant {
namespace {

const ScalarCurve& stiffness_of(const Material& material, const std::string& component) {
  const auto found = material.components.find(component);
  PLIANT_ASSERT(found != material.components.end() && found->second.stiffness,
                "a fit begins with a complete material");
  return *found->second.stiffness;
}

std::vector<std::string> names_of(const Material& material, const std::string& component) {
  return parameter_names({stiffness_of(material, component), FrictionLaw::none, {}}, component);
}

/// Bending springs are stiff per strain, hinges per curvature.
std::string unit_of(const Material& material, const std::string& component) {
  if (!is_bending(component)) return "N/m";
  return material.bending == "spring" ? "N" : "N m";
}

}  // namespace

std::vector<SheetUnknown> unknowns_of(const Material& material,
                                      const std::vector<ComponentGroup>& groups) {
  std::vector<SheetUnknown> unknowns;
  for (const ComponentGroup& group : groups) {
    const std::size_t first = unknowns.size();
    const std::string unit = unit_of(material, group.front());
    const std::vector<std::string> own = names_of(material, group.front());
    const std::vector<double>& knots = stiffness_of(material, group.front()).knots();
    for (std::size_t i = 0; i < own.size(); ++i) {
      unknowns.push_back({own[i], {}, unit, i < knots.size() ? knots[i] : 0});
    }
    for (const std::string& component : group) {
      const std::vector<std::string> names = names_of(material, component);
      PLIANT_ASSERT(first + names.size() == unknowns.size(), "a group shares one curve");
      for (std::size_t i = 0; i < names.size(); ++i) {
        unknowns[first + i].parameters.push_back(names[i]);
      }
    }
  }
  return unknowns;
}

Eigen::VectorXd control_values(const Material& material, const ComponentGroup& group) {
  const std::vector<double>& values = stiffness_of(material, group.front()).values();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void set_stiffness(Material& material, const ComponentGroup& group, const ScalarCurve& curve) {
  for (const std::string& component : group) material.components[component].stiffness = curve;
}

void set_values(Material& material, const std::vector<ComponentGroup>& groups,
                const Eigen::VectorXd& values) {
  Eigen::Index next = 0;
  for (const ComponentGroup& group : groups) {
    const ScalarCurve& curve = stiffness_of(material, group.front());
    const ScalarCurve changed = curve.with_values(values.data() + next);
    next += changed.size();
    set_stiffness(material, group, changed);
  }
}

}  // namespace pliant
