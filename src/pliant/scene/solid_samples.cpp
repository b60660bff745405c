#include "pliant/scene/solid_samples.h"

#include <algorithm>
#include <array>

#include <Eigen/LU>

#include "pliant/base/errors.h"
#include "pliant/material/fill.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {
namespace {

constexpr double kOnTheSurface = 1e-6;  // of an element's size

bool is_in_tetrahedron(const std::array<Eigen::Vector3d, 4>& x, const Eigen::Vector3d& place) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = x[static_cast<size_t>(i) + 1] - x[0];
  const Eigen::Vector3d shares = edges.partialPivLu().solve(place - x[0]);
  return shares.minCoeff() >= -kOnTheSurface && shares.sum() <= 1 + kOnTheSurface;
}

/// Six tetrahedra about the diagonal from node 0 to node 6 make a hexahedron.
constexpr int kOfHexahedron[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                     {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};

bool is_inside(const VolumeMesh& mesh, const Eigen::Vector3d& place) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::vector<int> nodes = mesh.nodes_of(e);
    const auto within = [&](const int(&corners)[4]) {
      std::array<Eigen::Vector3d, 4> x;
      for (size_t i = 0; i < 4; ++i) {
        x[i] = mesh.positions.col(nodes[static_cast<size_t>(corners[i])]);
      }
      return is_in_tetrahedron(x, place);
    };
    constexpr int kWhole[4] = {0, 1, 2, 3};
    if (nodes.size() == 4 ? within(kWhole) : std::ranges::any_of(kOfHexahedron, within))
      return true;
  }
  return false;
}

void require_blendable(const SceneSample& sample, const SceneSample& first) {
  const Material& material = sample.material.material;
  for (const auto& [name, component] : material.components) {
    if (!component.stiffness || !law_of(component).remembers()) continue;
    throw InputError(sample.where,
                     quoted_value(name) + " of " + quoted_value(material.name) +
                         " has friction or another law that remembers",
                     "samples of elastic materials");
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
  field.width = solid.width.value_or(spacing_of_neighbours(field.samples));
  return field;
}

}  // namespace pliant
