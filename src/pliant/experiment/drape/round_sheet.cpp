#include "pliant/experiment/drape/round_sheet.h"

#include <numbers>

#include <Eigen/Geometry>

#include "pliant/geometry/irregular_mesh.h"

namespace pliant {
namespace {

/// Rounding of a corner's distance (m).
constexpr double kOnCircle = 1e-9;

/// Vertices of a mesh on a disc or its rim, and of those the ones inside.
struct OnDisc {
  std::vector<char> held, inside;
};

OnDisc on_disc(const TriangleMesh& mesh, double radius, double edge) {
  OnDisc on;
  for (const auto& position : mesh.positions.colwise()) {
    const double distance = position.head<2>().norm();
    // Sides of the inner polygon dip into the circle: a vertex on one belongs to the rim.
    const double dip = edge * edge / (4 * radius);
    on.held.push_back(distance <= radius + kOnCircle);
    on.inside.push_back(distance < radius - dip - kOnCircle);
  }
  return on;
}

/// Triangles that move or touch the rim of the disc, with the vertices that they need.
RoundSheet outside_of(const TriangleMesh& mesh, const OnDisc& on) {
  RoundSheet sheet;
  std::vector<int> kept, number(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles.col(t);
    bool is_inside = true;
    for (const int v : corners) is_inside = is_inside && on.inside[static_cast<std::size_t>(v)];
    if (is_inside) continue;
    kept.push_back(t);
    for (const int v : corners) number[static_cast<std::size_t>(v)] = 0;
  }
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto place = static_cast<std::size_t>(v);
    if (number[place] < 0) continue;
    number[place] = static_cast<int>(vertices.size());
    if (on.held[place]) sheet.held.push_back(number[place]);
    vertices.push_back(v);
  }
  Eigen::Matrix3Xi triangles = mesh.triangles(Eigen::all, kept);
  for (int& v : triangles.reshaped()) v = number[static_cast<std::size_t>(v)];
  sheet.mesh = flat_mesh(mesh.positions(Eigen::seqN(0, 2), vertices), triangles);
  return sheet;
}

/// Where the vertices that are held end. A hinge stands for the curvature of half a triangle's
/// height on both of its sides: the first one, with all of its curvature beyond the disc, lies half
/// a height outside. With the first hinge on the disc's rim the specimen would bend in there too,
/// an error of first order in the edge.
double radius_held(const DrapeSetup& setup) {
  const double height = std::numbers::sqrt3 / 2 * setup.edge;
  return setup.disc / 2 + height / 2;
}

}  // namespace

RoundSheet round_sheet(const DrapeSetup& setup, double turn) {
  const double held = radius_held(setup);
  TriangleMesh disc = irregular_disc(setup.specimen / 2, held, setup.edge);
  const Eigen::Matrix2Xd turned =
      Eigen::Rotation2Dd(turn).toRotationMatrix() * disc.positions.topRows<2>();
  disc = flat_mesh(turned, disc.triangles);
  RoundSheet sheet = outside_of(disc, on_disc(disc, held, setup.edge));
  sheet.flat_area = rest_area(disc);
  return sheet;
}

}  // namespace pliant
