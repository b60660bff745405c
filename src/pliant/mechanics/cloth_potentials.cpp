#include "pliant/mechanics/cloth_potentials.h"

#include <cmath>
#include <numeric>
#include <optional>

#include "pliant/base/assert.h"
#include "pliant/geometry/grid_springs.h"
#include "pliant/geometry/hinges.h"
#include "pliant/material/bending_conversion.h"
#include "pliant/material/component_sum.h"
#include "pliant/material/density/in_plane.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/principal_metric.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/mechanics/element_potential.h"

namespace pliant {
namespace {

// A law of some components with its places in the system's parameter vector.
struct Law {
  std::shared_ptr<Sum> sum;
  std::vector<int> places;
  std::vector<std::string> field_names;
};

const std::vector<std::string>& membrane_components() {
  static const std::vector<std::string> names{"stretch.weft", "stretch.warp", "shear"};
  return names;
}

// The components that act on metrics of the strains of triangles.
std::vector<std::string> metric_components(const Material& material) {
  std::vector<std::string> names = components_of_sheet(material);
  std::erase_if(names, [](const std::string& name) { return !solid_metric_of(name); });
  return names;
}

void add_metrics(const Material& material, const DensityOptions& options, ComponentSum& sum) {
  for (const std::string& name : metric_components(material)) {
    const std::string metric = *solid_metric_of(name);
    DensityOptions own = options;
    if (find_principal_metric(metric)) own.damping_fraction = 0;  // which is which changes
    sum.add(name, /*strain=*/0, own, [&](std::shared_ptr<Sum> law) {
      return std::make_shared<InPlane>(law_on_metric(metric, std::move(law)));
    });
  }
}

Law make_law(const Material& material, const std::vector<std::string>& components,
             const DensityOptions& options, System& system) {
  ComponentSum sum(material);
  Law law;
  for (size_t i = 0; i < components.size(); ++i) {
    sum.add(components[i], static_cast<int>(i), options);
    law.field_names.push_back("strain." + components[i]);
  }
  if (components == membrane_components()) add_metrics(material, options, sum);
  NamedLaw named = std::move(sum).finish();
  law.sum = std::move(named.law);
  std::ranges::move(named.names.history, std::back_inserter(law.field_names));
  law.places = system.add_parameters(named.names.parameters, law.sum->parameters());
  return law;
}

template <class Measure>
void add_elements(System& system, const Stencils<Measure>& stencils, const Law& law, Cloth& cloth) {
  if (stencils.points.empty()) return;
  const auto potential =
      std::make_shared<ElementPotential<Measure>>(stencils, law.sum, law.places, law.field_names);
  system.add(potential);
  cloth.shown.push_back({potential, potential.get()});
}

// A place of a sheet at rest as its material samples have it.
Eigen::Vector3d in_space(const Eigen::Vector2d& place) { return {place.x(), place.y(), 0}; }

template <class Membrane>
void add_membrane(System& system, const TriangleMesh& mesh, int first_point,
                  const std::vector<int>& triangles, const MaterialSamples& samples, const Law& law,
                  Cloth& cloth) {
  Stencils<Membrane> stencils;
  std::vector<Eigen::Vector3d> middles;
  for (const int t : triangles) {
    const MembraneRest rest = membrane_rest(mesh.rest_triangle(t));
    const Eigen::Vector3i nodes = mesh.triangles.col(t).array() + first_point;
    stencils.add({nodes(0), nodes(1), nodes(2)}, rest, rest.area);
    middles.push_back(in_space(mesh.rest_triangle(t).rowwise().mean()));
  }
  stencils.weights = weights_at(samples, middles);
  add_elements(system, stencils, law, cloth);
}

void add_springs(System& system, const std::vector<GridSpring>& springs, int first_point,
                 bool bending, const Law& law, Cloth& cloth) {
  Stencils<Spring> stencils;
  for (const GridSpring& spring : springs) {
    stencils.add({spring.vertices[0] + first_point, spring.vertices[1] + first_point},
                 {spring.rest_length}, bending ? spring.rest_length : spring.area);
  }
  add_elements(system, stencils, law, cloth);
}

std::vector<Hinge> hinges_of(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  std::vector<bool> chosen(static_cast<size_t>(mesh.triangle_count()), false);
  for (const int t : triangles) chosen[static_cast<size_t>(t)] = true;
  std::vector<Hinge> hinges = find_hinges(mesh);
  std::erase_if(hinges,
                [&](const Hinge& h) { return !chosen[static_cast<size_t>(h.triangles[0])]; });
  return hinges;
}

// The middle of a hinge's edge at rest.
Eigen::Vector3d middle_of(const TriangleMesh& mesh, const Hinge& hinge) {
  const int t = hinge.triangles[0];
  Eigen::Vector2d middle(0, 0);
  for (int i = 0; i < 3; ++i) {
    const int vertex = mesh.triangles(i, t);
    if (vertex != hinge.vertices[0] && vertex != hinge.vertices[1]) continue;
    middle += mesh.rest_triangle(t).col(i) / 2;
  }
  return in_space(middle);
}

const std::vector<std::string>& bending_components() {
  static const std::vector<std::string> names{"bend.weft", "bend.warp", "bend.diagonal"};
  return names;
}

// What makes hinges of the laws of a sheet on this mesh.
BendingConversion hinge_conversion(const TriangleMesh& mesh, const std::vector<Hinge>& hinges,
                                   const Material& material, bool friction, Cloth& cloth) {
  if (material.bending_of != "sheet") return {};
  BendingLaws laws = bending_laws(material);
  if (!friction) {
    for (ComponentLaw& law : laws) law = law.without_friction();
  }
  const BendingVector stiffness = stiffness_at_rest(laws);
  if (stiffness.minCoeff() <= 0) return {};
  const BendingConverter converter(mesh, hinges);
  const BendingConversion conversion = converter(laws);
  constexpr double kNoticeable = 0.05;
  if (conversion.errors.cwiseAbs().maxCoeff() > kNoticeable) {
    cloth.warnings.push_back(
        "this mesh cannot bend as the material " + material.name +
        " does in every direction: its bending stiffness differs by up to " +
        std::to_string(std::lround(100 * conversion.errors.cwiseAbs().maxCoeff())) + " %");
  }
  return conversion;
}

// A material with the bending of a component as hinges have it.
Material with_hinge_strains(Material material, const std::string& component, double factor,
                            double slip) {
  const auto convert = [&](std::map<std::string, MaterialComponent>& components) {
    const auto own = components.find(component);
    if (own != components.end()) own->second = with_hinge_strains(own->second, factor, slip);
  };
  convert(material.components);
  for (SampledComponents& sample : material.samples.at) convert(sample.components);
  return material;
}

void add_shells(System& system, const TriangleMesh& mesh, int first_point, const Material& material,
                const std::vector<int>& triangles, const DensityOptions& options, Cloth& cloth) {
  const std::vector<Hinge> hinges = hinges_of(mesh, triangles);
  if (hinges.empty()) return;
  const std::vector<BendingVector> weights = bending_weights(hinges, bending_rule(mesh));
  const BendingConversion conversion =
      hinge_conversion(mesh, hinges, material, options.friction, cloth);
  for (int c = 0; c < 3; ++c) {
    const std::string& name = bending_components()[static_cast<size_t>(c)];
    const Law law =
        make_law(with_hinge_strains(material, name, conversion.factors(c), conversion.slip(c)),
                 {name}, options, system);
    Stencils<DiscreteShells> stencils;
    std::vector<Eigen::Vector3d> middles;
    for (size_t h = 0; h < hinges.size(); ++h) {
      const double part = weights[h](c) * conversion.factors(c);
      if (part <= 0) continue;
      const auto& v = hinges[h].vertices;
      stencils.add({v[0] + first_point, v[1] + first_point, v[2] + first_point, v[3] + first_point},
                   {0, hinges[h].height, 0}, part * hinges[h].area);
      middles.push_back(middle_of(mesh, hinges[h]));
    }
    stencils.weights = weights_at(material.samples, middles);
    add_elements(system, stencils, law, cloth);
  }
}

// The mesh of some triangles of another, with all its vertices.
TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  TriangleMesh part{mesh.positions, mesh.triangles(Eigen::all, triangles), {}};
  part.rest_corners.resize(2, 3 * part.triangle_count());
  for (int t = 0; t < part.triangle_count(); ++t) {
    part.rest_corners.middleCols<3>(3 * t) = mesh.rest_triangle(triangles[static_cast<size_t>(t)]);
  }
  return part;
}

}  // namespace

bool needs_grid(const Material& material) {
  return material.membrane == MembraneMeasure::spring || material.bending == "spring";
}

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) areas(mesh.triangles(i, t)) += rest_area(mesh, t) / 3;
  }
  return areas;
}

Cloth add_cloth(System& system, const TriangleMesh& mesh, int first_point, const Material& material,
                const std::vector<int>& triangles, const DensityOptions& options) {
  Cloth cloth;
  const auto law = [&](const std::vector<std::string>& components) {
    return make_law(material, components, options, system);
  };
  const std::optional<GridSprings> springs =
      needs_grid(material) ? std::optional(grid_springs(part_of(mesh, triangles))) : std::nullopt;
  switch (material.membrane) {
    case MembraneMeasure::stvk:
      add_membrane<StvkMembrane>(system, mesh, first_point, triangles, material.samples,
                                 law(membrane_components()), cloth);
      break;
    case MembraneMeasure::soft_constraint:
      add_membrane<SoftConstraintMembrane>(system, mesh, first_point, triangles, material.samples,
                                           law(membrane_components()), cloth);
      break;
    case MembraneMeasure::spring:
      for (const std::string& component : metric_components(material)) {
        cloth.warnings.push_back("springs of weft and warp are not coupled: the component `" +
                                 component + "` is left out");
      }
      add_springs(system, springs->along_u, first_point, false, law({"stretch.weft"}), cloth);
      add_springs(system, springs->along_v, first_point, false, law({"stretch.warp"}), cloth);
      add_springs(system, springs->diagonal, first_point, false, law({"shear"}), cloth);
      break;
  }
  if (material.bending == "spring") {
    add_springs(system, springs->bending_u, first_point, true, law({"bend.weft"}), cloth);
    add_springs(system, springs->bending_v, first_point, true, law({"bend.warp"}), cloth);
    add_springs(system, springs->bending_diagonal, first_point, true, law({"bend.diagonal"}),
                cloth);
  } else {
    add_shells(system, mesh, first_point, material, triangles, options, cloth);
  }
  return cloth;
}

Cloth add_cloth(System& system, const TriangleMesh& mesh, const Material& material,
                const DensityOptions& options) {
  std::vector<int> all(static_cast<size_t>(mesh.triangle_count()));
  std::iota(all.begin(), all.end(), 0);
  return add_cloth(system, mesh, 0, material, all, options);
}

}  // namespace pliant
