#include "pliant/estimation/number_errors.h"

#include <string>

#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

/// The component whose law a fit of isotropic sheets gives to another one.
std::string shared_component(std::string component) {
  const std::string own = ".warp";
  if (!component.ends_with(own)) return component;
  return component.replace(component.size() - own.size(), own.size(), ".weft");
}

NumberError error_of(const ParameterEstimate& p) {
  return {p.std_error, p.limit, p.determination, p.told_by};
}

/// @param name  by which the numbers of the component are called
std::map<std::string, NumberError> errors_of(const std::vector<ParameterEstimate>& parameters,
                                             const std::string& component,
                                             const std::string& name) {
  std::map<std::string, NumberError> errors;
  for (const ParameterEstimate& p : parameters) {
    if (p.owner != component || p.fixed || !p.name.starts_with(name + ".")) continue;
    errors[p.name.substr(name.size() + 1)] = error_of(p);
  }
  return errors;
}

}  // namespace

void state_errors(const std::vector<ParameterEstimate>& parameters, bool isotropic,
                  Material& material) {
  for (auto& [name, component] : material.components) {
    if (component.status != ComponentStatus::measured) continue;
    const std::string owner = isotropic ? shared_component(name) : name;
    component.errors = errors_of(parameters, owner, owner);
  }
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    for (auto& [name, component] : material.samples.at[k].components) {
      const std::string owner = isotropic ? shared_component(name) : name;
      component.errors = errors_of(parameters, owner, name_in_sample(k, owner));
    }
  }
  for (EnergyLimit& limit : material.limits) {
    const std::string name = limit_name(limit.of);
    for (const ParameterEstimate& p : parameters) {
      if (p.name == name && !p.fixed) limit.errors["energy"] = error_of(p);
    }
  }
}

}  // namespace pliant
