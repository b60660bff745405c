#include "pliant/geometry/volume_mesher.h"

#include "pliant/base/errors.h"

#ifdef PLIANT_HAS_CGAL

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace pliant {
namespace {

using VolumeKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ClosedSurface = CGAL::Surface_mesh<VolumeKernel::Point_3>;
using FilledDomain = CGAL::Polyhedral_mesh_domain_with_features_3<VolumeKernel, ClosedSurface>;
using FilledTriangulation = CGAL::Mesh_triangulation_3<FilledDomain>::type;
using FilledComplex =
    CGAL::Mesh_complex_3_in_triangulation_3<FilledTriangulation, FilledDomain::Corner_index,
                                            FilledDomain::Curve_index>;

using LabelDomain = CGAL::Labeled_mesh_domain_3<VolumeKernel>;
using LabelTriangulation = CGAL::Mesh_triangulation_3<LabelDomain>::type;
using LabelComplex = CGAL::Mesh_complex_3_in_triangulation_3<LabelTriangulation>;

// Edges that have a triangle on one side only, or two that run the same way along it.
void require_closed(const Eigen::Matrix3Xi& triangles, const std::string& file) {
  std::map<std::pair<int, int>, int> directed;
  for (const auto& t : triangles.colwise()) {
    for (int i = 0; i < 3; ++i) ++directed[{t(i), t((i + 1) % 3)}];
  }
  std::string open;
  int count = 0;
  for (const auto& [edge, times] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    if (times == 1 && back != directed.end()) continue;
    constexpr int kNamed = 3;
    if (count++ < kNamed) {
      open += fmt::format("{}{} to {}", open.empty() ? "" : ", ", edge.first, edge.second);
    }
  }
  if (count == 0) return;
  throw InputError(
      {file},
      fmt::format("the surface is not closed: {} edges have no triangle on their other "
                  "side (between vertices {}{}, counted from 0)",
                  count, open, count > 3 ? ", ..." : ""),
      "a surface around a volume, of which all triangles run the same way");
}

ClosedSurface closed_surface(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  double volume = 0;
  for (const auto& t : triangles.colwise()) {
    const Eigen::Vector3d a = positions.col(t(0)), b = positions.col(t(1)), c = positions.col(t(2));
    volume += a.dot(b.cross(c)) / 6;
  }
  ClosedSurface surface;
  std::vector<ClosedSurface::Vertex_index> vertices;
  for (const auto& p : positions.colwise()) {
    vertices.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  }
  for (const auto& t : triangles.colwise()) {
    const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(t(i))]; };
    if (volume > 0) {
      surface.add_face(vertex(0), vertex(1), vertex(2));
    } else {
      surface.add_face(vertex(0), vertex(2), vertex(1));
    }
  }
  return surface;
}

template <class Complex>
VolumeMesh mesh_of(const Complex& filled) {
  VolumeMesh mesh;
  std::map<typename Complex::Vertex_handle, int> numbers;
  std::vector<double> coordinates;
  std::vector<int> corners;
  for (auto cell = filled.cells_in_complex_begin(); cell != filled.cells_in_complex_end(); ++cell) {
    for (int i = 0; i < 4; ++i) {
      const auto vertex = cell->vertex(i);
      const auto [place, added] = numbers.try_emplace(vertex, static_cast<int>(numbers.size()));
      if (added) {
        const auto& p = vertex->point();
        coordinates.insert(coordinates.end(), {CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                               CGAL::to_double(p.z())});
      }
      corners.push_back(place->second);
    }
  }
  mesh.positions =
      Eigen::Map<const Eigen::Matrix3Xd>(coordinates.data(), 3, std::ssize(coordinates) / 3);
  mesh.tetrahedra = Eigen::Map<const TetrahedronList>(corners.data(), 4, std::ssize(corners) / 4);
  return mesh;
}

/// @param sag  of an edge, between surfaces and the mesh
template <class Complex, class Domain>
Complex filled(const Domain& domain, double edge, double sag) {
  namespace p = CGAL::parameters;
  constexpr double kSmallestAngle = 25;  // degrees, of triangles on surfaces
  constexpr double kShape = 2;           // circumradius over the shortest edge
  constexpr double kRadius = 0.72;       // of an edge, of a circumsphere; 0.61 where regular
  const CGAL::Mesh_criteria_3<typename Complex::Triangulation> criteria(
      p::edge_size = edge, p::facet_angle = kSmallestAngle, p::facet_size = edge,
      p::facet_distance = sag * edge, p::cell_radius_edge_ratio = kShape,
      p::cell_size = kRadius * edge);
  // Neither perturbed nor exuded: those go by addresses, and would give another mesh in each run.
  return CGAL::make_mesh_3<Complex>(domain, criteria, p::no_perturb(), p::no_exude());
}

/// All middles of voxels, and a little more: nothing outside has a label.
CGAL::Bbox_3 box_around(const LabelVolume& volume) {
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d at = volume.origin;
    for (int a = 0; a < 3; ++a) {
      if ((corner >> a) & 1) at += (volume.size(a) - 1) * volume.axes.col(a);
    }
    box.extend(at);
  }
  const Eigen::Vector3d more = 0.05 * box.sizes();
  const Eigen::Vector3d low = box.min() - more, high = box.max() + more;
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

}  // namespace

VolumeMesh fill_surface(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                        double edge, const std::string& file) {
  require_closed(triangles, file);
  const ClosedSurface surface = closed_surface(positions, triangles);
  CGAL::get_default_random() = CGAL::Random(0);  // else each mesh depends on those before it
  FilledDomain domain(surface);
  domain.detect_features();
  VolumeMesh mesh = mesh_of(filled<FilledComplex>(domain, edge, /*sag=*/0.05));
  if (mesh.tetrahedron_count() > 0) return mesh;
  throw InputError({file}, "the surface holds no volume that could be meshed",
                   "a surface that does not pass through itself, with edges of a length that fits");
}

VolumeMesh fill_labels(const LabelVolume& volume, double edge, const std::string& file) {
  constexpr double kSurface = 1e-3;  // of the box, to which surfaces are found
  const InputError nothing({file}, "has no region that could be meshed",
                           "labels above 0, of regions that are larger than `edge`");
  if (std::ranges::none_of(volume.labels, [](int label) { return label > 0; })) throw nothing;
  CGAL::get_default_random() = CGAL::Random(0);
  const auto label_at = [&](const VolumeKernel::Point_3& p) {
    return std::max(
        volume.at({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}), 0);
  };
  namespace p = CGAL::parameters;
  const LabelDomain domain(p::function = label_at, p::bounding_object = box_around(volume),
                           p::relative_error_bound = kSurface);
  const LabelComplex complex = filled<LabelComplex>(domain, edge, /*sag=*/0.25);
  VolumeMesh mesh = mesh_of(complex);
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end();
       ++cell) {
    mesh.labels.push_back(complex.subdomain_index(cell));
  }
  if (mesh.tetrahedron_count() == 0) throw nothing;
  return mesh;
}

}  // namespace pliant

#else

namespace pliant {

namespace {

[[noreturn]] void refuse_meshing(const std::string& file) {
  throw InputError({file}, "meshing of volumes was left out when this program was built",
                   "a program that was built with CGAL");
}

}  // namespace

VolumeMesh fill_surface(const Eigen::Matrix3Xd&, const Eigen::Matrix3Xi&, double,
                        const std::string& file) {
  refuse_meshing(file);
}

VolumeMesh fill_labels(const LabelVolume&, double, const std::string& file) {
  refuse_meshing(file);
}

}  // namespace pliant

#endif
