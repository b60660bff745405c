#include "pliant/estimation/sampled_numbers.h"

#include "pliant/base/assert.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

ComponentLaw known_law(const Material& material, const std::string& component) {
  const auto law = law_of(material, component);
  PLIANT_ASSERT(law.has_value(), "a fit has numbers of components with a law");
  return *law;
}

}  // namespace

int copies_of(const Material& material, const std::string& component) {
  return differs_in(material, component) ? static_cast<int>(material.samples.at.size()) : 1;
}

void append_unknowns(const Material& material, const ComponentGroup& group,
                     const std::vector<Unknown>& own, std::vector<Unknown>& unknowns) {
  if (!differs_in(material, group.front())) {
    unknowns.insert(unknowns.end(), own.begin(), own.end());
    return;
  }
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    const Eigen::VectorXd values =
        law_of(material.samples.at[k].components.at(group.front())).parameters();
    for (std::size_t i = 0; i < own.size(); ++i) {
      Unknown unknown = own[i];
      unknown.name = name_in_sample(k, unknown.name);
      for (std::string& parameter : unknown.parameters) parameter = name_in_sample(k, parameter);
      unknown.start = values(static_cast<Eigen::Index>(i));
      unknowns.push_back(std::move(unknown));
    }
  }
}

Eigen::Index set_numbers(const Eigen::VectorXd& numbers, Eigen::Index first,
                         const ComponentGroup& group, Material& material) {
  const ComponentLaw law = known_law(material, group.front());
  const Eigen::Index count = law.parameter_count();
  Eigen::Index next = first;
  const auto set = [&](std::map<std::string, MaterialComponent>& components) {
    const ComponentLaw other = law.with_parameters(numbers.segment(next, count));
    for (const std::string& name : group) set_law(components[name], other);
    next += count;
  };
  if (!differs_in(material, group.front())) {
    set(material.components);
    return next;
  }
  for (SampledComponents& sample : material.samples.at) set(sample.components);
  take_means(material);
  return next;
}

}  // namespace pliant
