#include "pliant/geometry/irregular_mesh.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"

#ifdef PLIANT_HAS_CGAL

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "pliant/geometry/mesh_quality.h"

namespace pliant {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

/// Refinement splits edges longer than a bound; the mean of those that are left is the bound over
/// this (measured on rectangles of 7 to 100 edges a side; within 2 %). It is also large enough that
/// the outline is not split.
constexpr double kBoundOverMeanEdge = 1.45;
/// sin^2 of the smallest angle after refinement (26.6 degrees). CGAL proves that refinement ends
/// for 0.125; for edges of one size, as here, it does up to 0.25 (Chew 1989).
constexpr double kShapeBound = 0.2;
/// Smoothing may make single angles smaller again; it stops before one gets below this.
constexpr double kSmallestAngle = 25 * std::numbers::pi / 180;
constexpr int kSmoothingSteps = 10;

/// Part i of a side cut into equal parts; exact at its ends, so that the outline has straight
/// sides.
double cut_point(double side, int i, int parts) { return i == parts ? side : side * i / parts; }

/// The outline, cut into equal parts, counter-clockwise from the lower left.
std::vector<Point> outline_points(double width, double height, double edge_length) {
  const auto parts_of = [&](double side) {
    return static_cast<int>(std::max(1L, std::lround(side / edge_length)));
  };
  const int across = parts_of(width), up = parts_of(height);
  std::vector<Point> points;
  for (int i = 0; i < across; ++i) points.emplace_back(cut_point(width, i, across), 0);
  for (int i = 0; i < up; ++i) points.emplace_back(width, cut_point(height, i, up));
  for (int i = across; i > 0; --i) points.emplace_back(cut_point(width, i, across), height);
  for (int i = up; i > 0; --i) points.emplace_back(0, cut_point(height, i, up));
  return points;
}

/// The outline's points and those that Delaunay refinement (Ruppert, Shewchuk) puts inside.
std::vector<Point> refined_points(const std::vector<Point>& outline, double edge_length) {
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& point : outline) vertices.push_back(triangulation.insert(point));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  }
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  CGAL::refine_Delaunay_mesh_2(triangulation,
                               Criteria(kShapeBound, kBoundOverMeanEdge * edge_length));
  std::vector<Point> points;
  for (const auto& vertex : triangulation.finite_vertex_handles())
    points.push_back(vertex->point());
  return points;
}

/// Sorts points into strips of one edge's height, each from left to right: neighbours have numbers
/// near to each other.
void sort_by_strips(double edge_length, std::vector<Point>& points) {
  const auto key = [&](const Point& p) {
    return std::tuple(std::floor(p.y() / edge_length), p.x(), p.y());
  };
  std::sort(points.begin(), points.end(),
            [&](const Point& a, const Point& b) { return key(a) < key(b); });
}

Eigen::Matrix3Xi delaunay_triangles(const Eigen::Matrix2Xd& points) {
  using Structure = CGAL::Triangulation_data_structure_2<
      CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;
  Triangulation triangulation;
  Triangulation::Face_handle near;
  for (int i = 0; i < points.cols(); ++i) {
    const auto vertex = triangulation.insert({points(0, i), points(1, i)}, near);
    vertex->info() = i;
    near = vertex->face();
  }
  std::vector<std::array<int, 3>> faces;
  for (const auto& face : triangulation.finite_face_handles()) {
    std::array<int, 3> corners{face->vertex(0)->info(), face->vertex(1)->info(),
                               face->vertex(2)->info()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.push_back(corners);
  }
  std::sort(faces.begin(), faces.end());
  return Eigen::Map<const Eigen::Matrix3Xi>(faces.data()->data(), 3,
                                            static_cast<Eigen::Index>(faces.size()));
}

/// One step of Lloyd's method: every inner point moves to the centroid of the triangles around it.
/// CGAL's own optimizer visits vertices in the order of their addresses, so that its results differ
/// from run to run.
TriangleMesh smoothed(const TriangleMesh& mesh, double width, double height) {
  Eigen::Matrix2Xd points = mesh.positions.topRows<2>();
  Eigen::Matrix2Xd moments = Eigen::Matrix2Xd::Zero(2, points.cols());
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points.cols());
  for (const auto& t : mesh.triangles.colwise()) {
    const Eigen::Vector2d a = points.col(t[0]), b = points.col(t[1]), c = points.col(t[2]);
    const double area = ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
    for (const int vertex : t) {
      moments.col(vertex) += area * (a + b + c) / 3;
      areas[vertex] += area;
    }
  }
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const bool inside =
        points(0, i) > 0 && points(0, i) < width && points(1, i) > 0 && points(1, i) < height;
    if (inside) points.col(i) = moments.col(i) / areas[i];
  }
  return flat_mesh(points, delaunay_triangles(points));
}

}  // namespace

TriangleMesh irregular_rectangle(double width, double height, double edge_length) {
  PLIANT_ASSERT(width > 0 && height > 0, "a rectangle has a positive width and height");
  PLIANT_ASSERT(edge_length > 0, "edges have a positive length");
  std::vector<Point> refined =
      refined_points(outline_points(width, height, edge_length), edge_length);
  sort_by_strips(edge_length, refined);
  Eigen::Matrix2Xd points(2, refined.size());
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) << refined[i].x(), refined[i].y();
  TriangleMesh mesh = flat_mesh(points, delaunay_triangles(points));
  for (int step = 0; step < kSmoothingSteps; ++step) {
    TriangleMesh next = smoothed(mesh, width, height);
    if (mesh_quality(next).smallest_angle < kSmallestAngle) break;
    mesh = std::move(next);
  }
  return mesh;
}

bool has_irregular_meshes() { return true; }

}  // namespace pliant

#else

namespace pliant {

TriangleMesh irregular_rectangle(double, double, double) {
  throw InputError({}, "this build of Pliant makes no irregular meshes (CGAL was missing)",
                   "a regular grid or a mesh file, or a build with libcgal-dev installed");
}

bool has_irregular_meshes() { return false; }

}  // namespace pliant

#endif
