#include "pliant/scene/solid_piece.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "pliant/material/material_samples.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/scene/solid_samples.h"

namespace pliant {
namespace {

void require_usable(const SceneMaterial& given, const Scene& scene) {
  const Material& material = given.material;
  const bool needed = scene.time.kind == SimulationKind::dynamic || !scene.gravity.isZero();
  if (material.density == 0 && needed) {
    throw InputError(given.where, "the material " + quoted_value(material.name) + " has no density",
                     "a material with \"density\" above zero (kg/m^3), for a solid that has mass");
  }
  const Eigen::Matrix<double, 6, 6> stiffness = stiffness_at_rest(solid_law(material));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(stiffness);
  if (eigen.eigenvalues()(0) > 1e-12 * eigen.eigenvalues()(5)) return;
  throw InputError(
      given.where,
      "the material " + quoted_value(material.name) + " does not resist every small strain",
      "components that together do: of volume and of shear");
}

std::vector<SolidPiece::Region> regions_of(const SceneSolid& solid, const VolumeMesh& mesh,
                                           const Scene& scene) {
  std::vector<SolidPiece::Region> regions;
  require_usable(solid.material, scene);
  if (solid.samples.empty()) {
    regions.push_back({held_beyond_range(solid.material.material), {}});
  } else {
    for (const SceneSample& sample : solid.samples) require_usable(sample.material, scene);
    regions.push_back({held_beyond_range(sampled_material(solid, mesh)), {}, densities_of(solid)});
  }
  for (const SolidRegion& region : solid.regions) {
    require_usable(region.material, scene);
    regions.push_back({held_beyond_range(region.material.material), {}});
  }
  const std::vector<int> material_of = material_of_elements(solid, mesh);
  for (size_t e = 0; e < material_of.size(); ++e) {
    regions[static_cast<size_t>(material_of[e])].elements.push_back(static_cast<int>(e));
  }
  std::erase_if(regions, [](const auto& region) { return region.elements.empty(); });
  return regions;
}

// The part of a mesh that is of one material, with all its nodes.
VolumeMesh part_of(const VolumeMesh& mesh, const std::vector<int>& elements) {
  std::vector<int> tetrahedra, hexahedra;
  for (const int e : elements) {
    const int tetrahedron_count = mesh.tetrahedron_count();
    if (e < tetrahedron_count) {
      tetrahedra.push_back(e);
    } else {
      hexahedra.push_back(e - tetrahedron_count);
    }
  }
  return {mesh.positions,
          mesh.tetrahedra(Eigen::all, tetrahedra),
          mesh.hexahedra(Eigen::all, hexahedra),
          {},
          {}};
}

// The mass of an element is shared alike by its nodes.
void add_masses_of_samples(const VolumeMesh& mesh, const SolidPiece::Region& region,
                           Eigen::VectorXd& masses) {
  const Eigen::VectorXd volumes = element_volumes(mesh);
  for (const int e : region.elements) {
    const std::vector<int> nodes = mesh.nodes_of(e);
    const Eigen::Vector3d centre = mesh.positions(Eigen::all, nodes).rowwise().mean();
    const Eigen::VectorXd weights = weights_at(region.material.samples, centre);
    const double mass = volumes(e) * weights.dot(region.densities);
    for (const int node : nodes) masses(node) += mass / static_cast<double>(nodes.size());
  }
}

double largest_stiffness(const SolidPiece::Region& region) {
  const auto of = [](const Material& material) {
    return stiffness_at_rest(solid_law(material)).diagonal().maxCoeff();
  };
  const Material& material = region.material;
  if (!is_heterogeneous(material)) return of(material);
  double largest = 0;
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    largest = std::max(largest, of(material_at(material, k)));
  }
  return largest;
}

}  // namespace

SolidPiece::EdgeLengths SolidPiece::edge_lengths() const {
  EdgeLengths lengths{INFINITY, 0, 0};
  for (const auto& corners : surface.colwise()) {
    for (int i = 0; i < 3; ++i) {
      const double length =
          (mesh.positions.col(corners(i)) - mesh.positions.col(corners((i + 1) % 3))).norm();
      lengths.shortest = std::min(lengths.shortest, length);
      lengths.longest = std::max(lengths.longest, length);
      lengths.mean += length / static_cast<double>(3 * surface.cols());
    }
  }
  return lengths;
}

Eigen::VectorXd SolidPiece::masses() const {
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(node_count());
  for (const Region& region : regions) {
    if (region.densities.size() > 0) {
      add_masses_of_samples(mesh, region, masses);
      continue;
    }
    masses += region.material.density * node_volumes(part_of(mesh, region.elements));
  }
  return masses;
}

Eigen::VectorXd SolidPiece::resistance_to_stretch() const {
  Eigen::VectorXd resistance = Eigen::VectorXd::Zero(node_count());
  const double edge = edge_lengths().mean;
  for (const Region& region : regions) {
    const double own = edge * largest_stiffness(region);
    for (const int e : region.elements) {
      for (const int node : mesh.nodes_of(e)) resistance(node) = std::max(resistance(node), own);
    }
  }
  return resistance;
}

SolidPiece make_solid_piece(const SceneSolid& solid, const Scene& scene) {
  SolidPiece piece;
  piece.name = solid.name;
  piece.mesh = make_volume_mesh(solid.mesh);
  piece.regions = regions_of(solid, piece.mesh, scene);
  piece.surface = boundary_surface(piece.mesh).triangles;
  piece.placed = piece.mesh.positions;
  for (auto position : piece.placed.colwise()) position = solid.place.apply(position.eval());
  return piece;
}

void add_solid_materials(System& system, const Scene& scene, SolidPiece& piece) {
  for (const SolidPiece::Region& region : piece.regions) {
    DensityOptions options;
    options.friction = scene.time.friction.has_value();
    options.friction_form = scene.time.friction.value_or(FrictionForm::variational);
    options.damping_fraction =
        scene.damping_fraction.value_or(region.material.damping_fraction.value_or(0));
    const Solid solid = add_solid(system, piece.mesh, piece.first_point,
                                  solid_law(region.material, options), region.elements);
    piece.shown.insert(piece.shown.end(), solid.shown.begin(), solid.shown.end());
  }
}

}  // namespace pliant
