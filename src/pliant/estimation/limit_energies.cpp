#include "pliant/estimation/limit_energies.h"

#include "pliant/material/sheet_metric.h"
#include "pliant/material/solid/principal_metric.h"

namespace pliant {

std::vector<double> energies_of_points(const std::string& component, const ComponentLaw& law,
                                       std::span<const double> strains) {
  const std::string metric = solid_metric_of(component).value_or(component);
  const std::size_t each = find_principal_metric(metric) ? 3 : 1;
  std::vector<double> energies(strains.size() / each, 0.0);
  for (std::size_t i = 0; i < each * energies.size(); ++i) {
    energies[i / each] += law.elastic_energy(strains[i]);
  }
  return energies;
}

}  // namespace pliant
