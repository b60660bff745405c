#include "pliant/scene/solid_samples.h"

#include <algorithm>

#include "pliant/base/errors.h"
#include "pliant/geometry/inside_volume.h"
#include "pliant/geometry/spread_points.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

void require_blendable(const SceneSample& sample) {
  const Material& material = sample.material.material;
  for (const auto& [name, component] : material.components) {
    if (!component.stiffness || !law_of(component).remembers()) continue;
    throw InputError(sample.where,
                     quoted_value(name) + " of " + quoted_value(material.name) +
                         " has friction or another law that remembers",
                     "samples of elastic materials");
  }
  if (is_heterogeneous(material)) {
    throw InputError(sample.where, quoted_value(material.name) + " has samples itself",
                     "samples of materials that are the same everywhere");
  }
  if (!material.limits.empty()) {
    throw InputError(sample.where, quoted_value(material.name) + " has limits of energy",
                     "samples of materials without them");
  }
}

}  // namespace

Material sampled_material(const SceneSolid& solid, const VolumeMesh& mesh) {
  Material together = solid.material.material;
  std::vector<Eigen::Vector3d> places;
  for (const SceneSample& sample : solid.samples) {
    require_blendable(sample);
    if (!is_inside(mesh, sample.at)) {
      throw InputError(sample.where, "lies outside the body",
                       "a place within the mesh, in its own coordinates");
    }
    if (std::ranges::find(places, sample.at) != places.end()) {
      throw InputError(sample.where, "is a second sample at one place", "each place once");
    }
    places.push_back(sample.at);
    SampledComponents& own = together.samples.at.emplace_back(SampledComponents{sample.at, {}});
    for (const auto& [name, component] : sample.material.material.components) {
      if (!component.stiffness) continue;
      own.components[name] = component;
      together.components.emplace(name, component);
    }
  }
  together.samples.width = solid.width.value_or(spacing_of_neighbours(places));
  return together;
}

Eigen::VectorXd densities_of(const SceneSolid& solid) {
  Eigen::VectorXd densities(std::ssize(solid.samples));
  for (Eigen::Index k = 0; k < densities.size(); ++k) {
    densities(k) = solid.samples[static_cast<std::size_t>(k)].material.material.density;
  }
  return densities;
}

}  // namespace pliant
