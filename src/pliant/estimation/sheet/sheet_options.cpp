#include "pliant/estimation/sheet/sheet_options.h"

#include <algorithm>

#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/estimation/parameter_option.h"
#include "pliant/estimation/sheet/first_laws.h"
#include "pliant/material/fill.h"

namespace pliant {
namespace {

std::vector<std::string> known_parameters(const FitSettings& settings,
                                          const std::vector<const SheetTest*>& tests) {
  std::vector<std::string> names;
  std::vector<std::string> components = sheet_component_names();
  for (const SheetMetric& metric : sheet_metrics()) components.emplace_back(metric.name);
  for (const std::string& component : components) {
    names.push_back(component + ".k");
    if (is_bending(component) && !states_friction(settings, {component})) continue;
    for (const char* part : {".friction.a", ".friction.b", ".friction.tau"}) {
      names.push_back(component + part);
    }
  }
  for (const SheetTest* test : tests) {
    for (const NuisanceParameter& cord : test->nuisance()) names.push_back(cord.name);
  }
  return names;
}

template <class T>
void require_known(const std::map<std::string, T>& options, const char* field,
                   const std::vector<std::string>& names, const FitSettings& settings) {
  for (const auto& option : options) {
    const std::string& key = option.first;
    const bool known =
        std::ranges::any_of(names, [&](const std::string& name) { return matches(key, name); });
    if (known) continue;
    throw InputError({settings.file, 0, field},
                     quoted_value(key) + " matches no parameter of a fit of sheets",
                     "COMPONENT.k, which stands for all control values of a stiffness; of stretch "
                     "and shear, and of bending whose friction the model states, .friction.a, "
                     ".friction.b, .friction.tau; "
                     "EXPERIMENT.CLIP.CORD.cord_friction where it is unknown; patterns with *");
  }
}

}  // namespace

std::optional<double> fixed_stiffness(const FitOptions& options, const ComponentGroup& group) {
  for (const std::string& component : group) {
    if (const auto value = option_for(component + ".k", options.fix)) return value;
  }
  return std::nullopt;
}

void require_known_parameters(const FitSettings& settings,
                              const std::vector<const SheetTest*>& tests) {
  const std::vector<std::string> names = known_parameters(settings, tests);
  require_known(settings.fit.bounds, "fit.bounds", names, settings);
  require_known(settings.fit.fix, "fit.fix", names, settings);
  require_known(settings.fit.priors, "fit.priors", names, settings);
}

}  // namespace pliant
