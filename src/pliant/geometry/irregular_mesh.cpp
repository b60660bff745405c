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

/// A straight line that edges of the mesh run along.
struct Line {
  Eigen::Vector2d from, to;

  /// Without tolerance where it runs along an axis: points on such a line have its very coordinate.
  bool holds(const Eigen::Vector2d& point) const {
    const Eigen::AlignedBox2d box(from.cwiseMin(to), from.cwiseMax(to));
    if (from.x() == to.x() || from.y() == to.y()) return box.contains(point);
    constexpr double kRounding = 1e-9;
    const Eigen::Vector2d along = to - from, there = point - from;
    const double apart = along.x() * there.y() - along.y() * there.x();
    return std::abs(apart) <= kRounding * along.squaredNorm() &&
           box.exteriorDistance(point) <= kRounding * along.norm();
  }
};

/// Counter-clockwise from the lower left.
Eigen::Matrix<double, 2, 4> corners_of(const Eigen::AlignedBox2d& box) {
  Eigen::Matrix<double, 2, 4> corners;
  corners << box.min().x(), box.max().x(), box.max().x(), box.min().x(),  //
      box.min().y(), box.min().y(), box.max().y(), box.max().y();
  return corners;
}

/// The sides of boxes, counter-clockwise from the lower left of each.
std::vector<Line> sides_of(const std::vector<Eigen::AlignedBox2d>& boxes) {
  std::vector<Line> sides;
  for (const Eigen::AlignedBox2d& box : boxes) {
    const Eigen::Matrix<double, 2, 4> corners = corners_of(box);
    for (int i = 0; i < 4; ++i) sides.push_back({corners.col(i), corners.col((i + 1) % 4)});
  }
  return sides;
}

/// The points of a set that lie on a line, in its order.
std::vector<int> indices_on(const Line& line, const Eigen::Matrix2Xd& points) {
  std::vector<int> indices;
  for (int i = 0; i < points.cols(); ++i) {
    if (line.holds(points.col(i))) indices.push_back(i);
  }
  const Eigen::Vector2d along = line.to - line.from;
  std::sort(indices.begin(), indices.end(),
            [&](int a, int b) { return along.dot(points.col(a)) < along.dot(points.col(b)); });
  return indices;
}

/// A line, cut at the corners that lie on it and between them into equal parts. The same points in
/// whichever direction it runs, its corners exactly.
std::vector<Point> cut(const Line& line, const Eigen::Matrix2Xd& corners, double edge_length) {
  const std::vector<int> stops = indices_on(line, corners);
  std::vector<Point> points;
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    const Eigen::Vector2d from = corners.col(stops[s]), to = corners.col(stops[s + 1]);
    const Eigen::Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
    const double length = (high - low).norm();
    if (length == 0) continue;
    const auto parts = std::max(1L, std::lround(length / edge_length));
    const bool rises = from == low;
    points.emplace_back(from.x(), from.y());
    for (long i = 1; i < parts; ++i) {
      const double part = static_cast<double>(rises ? i : parts - i);
      const Eigen::Vector2d point = low + (high - low) * part / static_cast<double>(parts);
      points.emplace_back(point.x(), point.y());
    }
  }
  points.emplace_back(line.to.x(), line.to.y());
  return points;
}

/// The points of lines, each cut, and those that Delaunay refinement (Ruppert, Shewchuk) adds.
std::vector<Point> refined_points(const std::vector<Line>& lines, const Eigen::Matrix2Xd& corners,
                                  double edge_length) {
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  Triangulation triangulation;
  for (const Line& line : lines) {
    const std::vector<Point> points = cut(line, corners, edge_length);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      triangulation.insert_constraint(points[i], points[i + 1]);
    }
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

Eigen::Matrix3Xi delaunay_triangles(const Eigen::Matrix2Xd& points,
                                    const std::vector<Line>& lines) {
  using Structure =
      CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  Triangulation::Face_handle near;
  for (int i = 0; i < points.cols(); ++i) {
    vertices.push_back(triangulation.insert({points(0, i), points(1, i)}, near));
    vertices.back()->info() = i;
    near = vertices.back()->face();
  }
  for (const Line& line : lines) {
    const std::vector<int> on_line = indices_on(line, points);
    for (std::size_t i = 0; i + 1 < on_line.size(); ++i) {
      triangulation.insert_constraint(vertices[static_cast<std::size_t>(on_line[i])],
                                      vertices[static_cast<std::size_t>(on_line[i + 1])]);
    }
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

/// One step of Lloyd's method: every point off the lines moves to the centroid of the triangles
/// around it.
/// CGAL's own optimizer visits vertices in the order of their addresses, so that its results differ
/// from run to run.
TriangleMesh smoothed(const TriangleMesh& mesh, const std::vector<Line>& lines) {
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
    const bool stays =
        std::ranges::any_of(lines, [&](const Line& line) { return line.holds(points.col(i)); });
    if (!stays) points.col(i) = moments.col(i) / areas[i];
  }
  return flat_mesh(points, delaunay_triangles(points, lines));
}

/// The mesh of what the lines enclose.
/// @param corners  ends of lines
TriangleMesh mesh_between(const std::vector<Line>& lines, const Eigen::Matrix2Xd& corners,
                          double edge_length) {
  std::vector<Point> refined = refined_points(lines, corners, edge_length);
  sort_by_strips(edge_length, refined);
  Eigen::Matrix2Xd points(2, refined.size());
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) << refined[i].x(), refined[i].y();
  TriangleMesh mesh = flat_mesh(points, delaunay_triangles(points, lines));
  for (int step = 0; step < kSmoothingSteps; ++step) {
    TriangleMesh next = smoothed(mesh, lines);
    if (mesh_quality(next).smallest_angle < kSmallestAngle) break;
    mesh = std::move(next);
  }
  return mesh;
}

/// Corners of the regular polygon in a circle about the origin whose sides are nearest to a length.
Eigen::Matrix2Xd polygon_in_circle(double radius, double side) {
  const auto parts = std::max(6L, std::lround(2 * std::numbers::pi * radius / side));
  Eigen::Matrix2Xd corners(2, parts);
  for (long i = 0; i < parts; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(parts);
    corners.col(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return corners;
}

}  // namespace

TriangleMesh irregular_rectangle(double width, double height, double edge_length,
                                 const std::vector<Eigen::AlignedBox2d>& regions) {
  PLIANT_ASSERT(width > 0 && height > 0, "a rectangle has a positive width and height");
  PLIANT_ASSERT(edge_length > 0, "edges have a positive length");
  const Eigen::AlignedBox2d whole(Eigen::Vector2d::Zero(), Eigen::Vector2d(width, height));
  std::vector<Eigen::AlignedBox2d> boxes{whole};
  boxes.insert(boxes.end(), regions.begin(), regions.end());
  Eigen::Matrix2Xd corners(2, 4 * boxes.size());
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    PLIANT_ASSERT(whole.contains(boxes[b]), "regions lie within the rectangle");
    corners.middleCols<4>(static_cast<Eigen::Index>(4 * b)) = corners_of(boxes[b]);
  }
  return mesh_between(sides_of(boxes), corners, edge_length);
}

TriangleMesh irregular_disc(double radius, double inner_radius, double edge_length) {
  PLIANT_ASSERT(edge_length > 0, "edges have a positive length");
  PLIANT_ASSERT(0 < inner_radius && inner_radius < radius, "the inner circle lies in the outer");
  std::vector<Line> lines;
  Eigen::Matrix2Xd corners(2, 0);
  for (const double circle : {inner_radius, radius}) {
    const Eigen::Matrix2Xd polygon = polygon_in_circle(circle, edge_length);
    for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
      lines.push_back({polygon.col(i), polygon.col((i + 1) % polygon.cols())});
    }
    corners.conservativeResize(2, corners.cols() + polygon.cols());
    corners.rightCols(polygon.cols()) = polygon;
  }
  return mesh_between(lines, corners, edge_length);
}

bool has_irregular_meshes() { return true; }

}  // namespace pliant

#else

namespace pliant {

TriangleMesh irregular_rectangle(double, double, double, const std::vector<Eigen::AlignedBox2d>&) {
  throw InputError({}, "this build of Pliant makes no irregular meshes (CGAL was missing)",
                   "a regular grid or a mesh file, or a build with libcgal-dev installed");
}

TriangleMesh irregular_disc(double, double, double) {
  throw InputError({}, "this build of Pliant makes no round meshes (CGAL was missing)",
                   "a build with libcgal-dev installed");
}

bool has_irregular_meshes() { return false; }

}  // namespace pliant

#endif
