#include "pliant/scene/solid_samples.h"

#include <algorithm>

#include "pliant/base/errors.h"
#include "pliant/geometry/inside_volume.h"
#include "pliant/geometry/spread_points.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {
namespace {

void require_blendable(const SceneSample& sample, const SceneSample& first) {
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
  if (is_known(material, "J") == is_known(first.material.material, "J")) return;
  throw InputError(sample.where,
                   "only some of the samples resist a change of volume by a component `J`",
                   "all of them, or none");
}

}  // namespace

SolidField solid_field(const SceneSolid& solid, const VolumeMesh& mesh) {
  SolidField field;
  for (const SceneSample& sample : solid.samples) {
    require_blendable(sample, solid.samples.front());
    if (!is_inside(mesh, sample.at)) {
      throw InputError(sample.where, "lies outside the body",
                       "a place within the mesh, in its own coordinates");
    }
    for (const MaterialSample& other : field.samples) {
      if (other.place != sample.at) continue;
      throw InputError(sample.where, "is a second sample at one place", "each place once");
    }
    field.samples.push_back({sample.at, held_beyond_range(sample.material.material)});
  }
  std::vector<Eigen::Vector3d> places;
  for (const MaterialSample& sample : field.samples) places.push_back(sample.place);
  field.width = solid.width.value_or(spacing_of_neighbours(places));
  return field;
}

}  // namespace pliant
