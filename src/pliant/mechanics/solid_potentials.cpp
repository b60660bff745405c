#include "pliant/mechanics/solid_potentials.h"

#include <array>
#include <numeric>

#include "pliant/geometry/hexahedron_shape.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/strain/hexahedron_dilatation.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/mechanics/element_potential.h"
#include "pliant/mechanics/nodal_dilatation.h"

namespace pliant {
namespace {

// Elements of a solid, all of one material, by their kind.
struct SolidPart {
  const VolumeMesh& mesh;
  int first_point = 0;
  std::vector<int> tetrahedra, hexahedra;  // columns of the lists of the mesh

  template <int Nodes>
  std::array<int, static_cast<size_t>(Nodes)> points(
      const Eigen::Matrix<int, Nodes, Eigen::Dynamic>& all, int element) const {
    std::array<int, static_cast<size_t>(Nodes)> points{};
    for (int i = 0; i < Nodes; ++i) points[static_cast<size_t>(i)] = all(i, element) + first_point;
    return points;
  }
};

SolidPart part_of(const VolumeMesh& mesh, int first_point, const std::vector<int>& elements) {
  SolidPart part{mesh, first_point, {}, {}};
  const int tetrahedra = mesh.tetrahedron_count();
  for (const int e : elements) {
    if (e < tetrahedra) {
      part.tetrahedra.push_back(e);
    } else {
      part.hexahedra.push_back(e - tetrahedra);
    }
  }
  return part;
}

// Where the parameters of a part of a law stand among the system's.
struct LawPlaces {
  std::vector<int> of_points, of_volume;
};

LawPlaces add_parameters(System& system, const SolidLaw& law) {
  LawPlaces places;
  if (law.parameters.empty()) return places;
  Eigen::VectorXd values = law.of_points->parameters();
  const auto own = values.size();
  if (law.of_volume) {
    const Eigen::VectorXd of_volume = law.of_volume->parameters();
    values.conservativeResize(own + of_volume.size());
    values.tail(of_volume.size()) = of_volume;
  }
  const std::vector<int> all = system.add_parameters(law.parameters, values);
  places.of_points.assign(all.begin(), all.begin() + own);
  places.of_volume.assign(all.begin() + own, all.end());
  return places;
}

template <class Part>
void add_shown(System& system, const std::shared_ptr<Part>& potential, Solid& solid) {
  system.add(potential);
  solid.shown.push_back({potential, potential.get()});
}

void add_tetrahedra(System& system, const SolidPart& part, const SolidLaw& law,
                    const LawPlaces& places, Solid& solid) {
  if (part.tetrahedra.empty()) return;
  Stencils<LinearTetrahedron> stencils;
  std::vector<Eigen::Vector3d> middles;
  for (const int t : part.tetrahedra) {
    const LinearTetrahedron::Positions x =
        part.mesh.positions(Eigen::all, part.mesh.tetrahedra.col(t));
    stencils.add(part.points(part.mesh.tetrahedra, t), tetrahedron_rest(x), tetrahedron_volume(x));
    middles.emplace_back(x.rowwise().mean());
  }
  stencils.weights = weights_at(law.samples, middles);
  add_shown(system,
            std::make_shared<ElementPotential<LinearTetrahedron>>(
                stencils, law.of_points, places.of_points, law.point_fields),
            solid);
  if (!law.of_volume) return;
  NodalDilatation::Weights weights;
  if (!law.samples.at.empty()) {
    weights = [&](int point) {
      return weights_at(law.samples, part.mesh.positions.col(point - part.first_point));
    };
  }
  add_shown(system,
            std::make_shared<NodalDilatation>(stencils.points, stencils.sizes, law.of_volume,
                                              places.of_volume, law.volume_fields, weights),
            solid);
}

void add_hexahedra(System& system, const SolidPart& part, const SolidLaw& law,
                   const LawPlaces& places, Solid& solid) {
  if (part.hexahedra.empty()) return;
  Stencils<TrilinearHexahedron> stencils;  // eight for each element
  Stencils<HexahedronDilatation> dilatations;
  std::vector<Eigen::Vector3d> points_at, middles;
  for (const int h : part.hexahedra) {
    const TrilinearHexahedron::Positions x =
        part.mesh.positions(Eigen::all, part.mesh.hexahedra.col(h));
    const auto points = part.points(part.mesh.hexahedra, h);
    double volume = 0;
    const auto of_element = hexahedron_points(x);
    for (size_t p = 0; p < of_element.size(); ++p) {
      stencils.add(points, of_element[p].rest, of_element[p].size);
      points_at.emplace_back(x * hexahedron_shares()[p]);
      volume += of_element[p].size;
    }
    dilatations.add(points, {volume}, volume);
    middles.emplace_back(x.rowwise().mean());
  }
  stencils.weights = weights_at(law.samples, points_at);
  dilatations.weights = weights_at(law.samples, middles);
  add_shown(system,
            std::make_shared<ElementPotential<TrilinearHexahedron>>(
                stencils, law.of_points, places.of_points, law.point_fields),
            solid);
  if (!law.of_volume) return;
  add_shown(system,
            std::make_shared<ElementPotential<HexahedronDilatation>>(
                dilatations, law.of_volume, places.of_volume, law.volume_fields),
            solid);
}

}  // namespace

Solid add_solid(System& system, const VolumeMesh& mesh, int first_point, const SolidLaw& law,
                const std::vector<int>& elements) {
  Solid solid;
  const SolidPart part = part_of(mesh, first_point, elements);
  const LawPlaces places = add_parameters(system, law);
  add_tetrahedra(system, part, law, places, solid);
  add_hexahedra(system, part, law, places, solid);
  return solid;
}

Solid add_solid(System& system, const VolumeMesh& mesh, const SolidLaw& law) {
  std::vector<int> all(static_cast<size_t>(mesh.element_count()));
  std::iota(all.begin(), all.end(), 0);
  return add_solid(system, mesh, 0, law, all);
}

Eigen::Matrix3Xd traction_forces(const Eigen::Matrix3Xd& positions,
                                 const Eigen::Matrix3Xi& triangles,
                                 const Eigen::Vector3d& traction) {
  return traction * node_areas(positions, triangles).transpose();
}

}  // namespace pliant
