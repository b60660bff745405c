#include "pliant/material/component_sum.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/material/density/blended_density.h"
#include "pliant/material/density/limited_density.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

void append(std::vector<std::string> more, std::vector<std::string>& names) {
  std::ranges::move(more, std::back_inserter(names));
}

}  // namespace

ComponentSum::ComponentSum(const Material& material)
    : material_(material), limited_(material.limits.size()) {}

AddedNames ComponentSum::add_blended(const std::string& component, int strain,
                                     const DensityOptions& options, LawPart part, Sum& sum) const {
  BlendedDensity::Laws laws;
  AddedNames names;
  for (std::size_t k = 0; k < material_.samples.at.size(); ++k) {
    const auto own = std::make_shared<Sum>();
    laws.push_back(own);
    const auto& components = material_.samples.at[k].components;
    const auto found = components.find(component);
    if (found == components.end()) continue;
    Material sample;
    sample.components.insert(*found);
    const AddedNames added = add_component(sample, component, strain, options, *own, part);
    for (const std::string& name : added.parameters) {
      names.parameters.push_back(name_in_sample(k, name));
    }
  }
  sum.add_addend(
      std::make_shared<BlendedDensity>(std::move(laws), is_alike_everywhere(material_, component)));
  return names;
}

AddedNames ComponentSum::add_law(const std::string& component, int strain,
                                 const DensityOptions& options, LawPart part, Sum& sum) const {
  return differs_in(material_, component)
             ? add_blended(component, strain, options, part, sum)
             : add_component(material_, component, strain, options, sum, part);
}

void ComponentSum::add_part(const std::string& component, int strain, const DensityOptions& options,
                            LawPart part, const Place& place, Sum& sum, AddedNames& names) const {
  const auto own = std::make_shared<Sum>();
  AddedNames added = add_law(component, strain, options, part, place ? *own : sum);
  if (place && !own->is_empty()) sum.add_addend(place(own));
  append(std::move(added.parameters), names.parameters);
  append(std::move(added.history), names.history);
}

void ComponentSum::add(const std::string& component, int strain, const DensityOptions& options,
                       const Place& place) {
  for (std::size_t i = 0; i < limited_.size(); ++i) {
    if (std::ranges::find(material_.limits[i].of, component) == material_.limits[i].of.end()) {
      continue;
    }
    AddedNames names;
    Limited& limited = limited_[i];
    add_part(component, strain, options, LawPart::elastic, place, *limited.law, names);
    append(std::move(names.parameters), limited.parameters);
    ++limited.components;
    add_part(component, strain, options, LawPart::rest, place, *all_.law, all_.names);
    return;
  }
  add_part(component, strain, options, LawPart::all, place, *all_.law, all_.names);
}

NamedLaw ComponentSum::finish() && {
  for (std::size_t i = 0; i < limited_.size(); ++i) {
    const EnergyLimit& limit = material_.limits[i];
    if (limited_[i].components == 0) continue;
    PLIANT_ASSERT(limited_[i].components == std::ssize(limit.of),
                  "the components of a limit act on the same points");
    all_.law->add_addend(std::make_shared<LimitedDensity>(limited_[i].law, limit.energy));
    append(std::move(limited_[i].parameters), all_.names.parameters);
    all_.names.parameters.push_back(limit_name(limit.of));
  }
  return std::move(all_);
}

}  // namespace pliant
