#include "pliant/geometry/mesh_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/geometry/rest_shape.h"
#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

/// Area over the square of the longest edge: 0.43 for an equilateral triangle. Below, the rest
/// plane's axes are lost in the rounding of single-precision files.
constexpr double kSmallestShape = 1e-6;
/// Longest edge of a triangle over the size of the mesh.
constexpr double kSmallestSize = 1e-9;

constexpr const char* kSomeArea = "corners that are not in one line, and apart from each other";

/// Looks at a mesh from all sides and keeps what it finds.
class MeshInspector {
 public:
  MeshInspector(const TriangleMesh& mesh, const MeshNumbering& numbering)
      : mesh_(mesh), numbering_(numbering) {}

  std::vector<MeshProblem> inspect() && {
    if (mesh_.triangle_count() == 0) add(0, "the mesh has no triangles", "a surface");
    check_vertex_numbers();
    if (!problems_.empty()) return std::move(problems_);
    check_finite();
    check_duplicates();
    check_areas();
    check_edges();
    check_isolated_vertices();
    return std::move(problems_);
  }

 private:
  void add(int line, std::string text, std::string expected) {
    if (problems_.size() >= kMaxMeshProblems) return;
    problems_.push_back({std::move(text), std::move(expected), line});
  }

  void add_triangle(int triangle, std::string_view what, std::string expected) {
    const Eigen::Vector3i v = mesh_.triangles.col(triangle);
    add(numbering_.line_of(triangle),
        fmt::format("face {} (vertices {}, {}, {}) {}", face(triangle), numbering_.shown(v[0]),
                    numbering_.shown(v[1]), numbering_.shown(v[2]), what),
        std::move(expected));
  }

  int face(int triangle) const { return numbering_.shown(numbering_.face_of(triangle)); }

  void check_vertex_numbers() {
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const Eigen::Vector3i v = mesh_.triangles.col(t);
      if (v.minCoeff() < 0 || v.maxCoeff() >= mesh_.vertex_count()) {
        add_triangle(
            t, fmt::format("has a vertex that is not there (there are {})", mesh_.vertex_count()),
            fmt::format("numbers from {} to {}", numbering_.shown(0),
                        numbering_.shown(mesh_.vertex_count() - 1)));
      } else if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        add_triangle(t, "has a vertex twice", "three different vertices");
      }
    }
  }

  void check_finite() {
    for (int i = 0; i < mesh_.vertex_count(); ++i) {
      if (mesh_.positions.col(i).allFinite()) continue;
      add(numbering_.line_of_vertex(i),
          fmt::format("the position of vertex {} is not finite", numbering_.shown(i)),
          "finite coordinates");
    }
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      if (mesh_.rest_triangle(t).allFinite()) continue;
      add_triangle(t, "has no finite rest shape", "finite coordinates");
    }
  }

  void check_duplicates() {
    std::vector<std::pair<std::array<int, 3>, int>> triangles;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      std::array<int, 3> v{mesh_.triangles(0, t), mesh_.triangles(1, t), mesh_.triangles(2, t)};
      std::sort(v.begin(), v.end());
      triangles.emplace_back(v, t);
    }
    std::sort(triangles.begin(), triangles.end());
    for (std::size_t i = 1; i < triangles.size(); ++i) {
      if (triangles[i].first != triangles[i - 1].first) continue;
      add_triangle(triangles[i].second,
                   fmt::format("has the vertices of face {}", face(triangles[i - 1].second)),
                   "each face once");
    }
  }

  void check_areas() {
    const double space_size = size_of(mesh_.positions), rest_size = size_of(mesh_.rest_corners);
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const Eigen::Matrix<double, 2, 3> rest = mesh_.rest_triangle(t);
      const double area = rest_area(mesh_, t);
      if (is_degenerate(std::abs(area), rest, rest_size)) {
        add_triangle(t, fmt::format("has no area at rest ({:.3g} m^2)", area), kSomeArea);
      } else if (area < 0) {
        add_triangle(t, fmt::format("is inverted at rest (its area is {:.3g} m^2)", area),
                     "corners that run counter-clockwise at rest");
      }
      Eigen::Matrix3d space;
      for (int k = 0; k < 3; ++k) space.col(k) = mesh_.positions.col(mesh_.triangles(k, t));
      if (is_degenerate(space_area(mesh_, t), space, space_size)) {
        add_triangle(t, fmt::format("has no area in space ({:.3g} m^2)", space_area(mesh_, t)),
                     kSomeArea);
      }
    }
  }

  template <typename Points>
  static double size_of(const Points& points) {
    return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  }

  template <typename Corners>
  static bool is_degenerate(double area, const Corners& corners, double mesh_size) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, (corners.col((k + 1) % 3) - corners.col(k)).norm());
    }
    return area <= kSmallestShape * longest * longest || longest <= kSmallestSize * mesh_size;
  }

  void check_edges() {
    const std::vector<TriangleSide> sides = sides_by_edge(mesh_.triangles);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      const auto edge = std::minmax(sides[begin].from, sides[begin].to);
      while (end < sides.size() && std::minmax(sides[end].from, sides[end].to) == edge) ++end;
      const std::span edge_sides(sides.data() + begin, end - begin);
      if (edge_sides.size() > 2) {
        add_edge(edge_sides, fmt::format("is shared by {} triangles", edge_sides.size()),
                 "one or two triangles at every edge of a sheet");
      } else if (edge_sides.size() == 2 && edge_sides[0].from == edge_sides[1].from) {
        add_edge(edge_sides, "has two triangles that run the same way along it",
                 "neighbours that face the same side");
      }
    }
  }

  void add_edge(std::span<const TriangleSide> sides, std::string_view what, std::string expected) {
    std::vector<int> faces;
    for (const TriangleSide& side : sides.first(std::min<std::size_t>(sides.size(), 5))) {
      faces.push_back(face(side.triangle));
    }
    const auto [low, high] = std::minmax(sides[0].from, sides[0].to);
    add(numbering_.line_of(sides[0].triangle),
        fmt::format("the edge between vertices {} and {} {} (faces {}{})", numbering_.shown(low),
                    numbering_.shown(high), what, fmt::join(faces, ", "),
                    sides.size() > faces.size() ? ", ..." : ""),
        std::move(expected));
  }

  void check_isolated_vertices() {
    std::vector<bool> used(static_cast<std::size_t>(mesh_.vertex_count()), false);
    for (const int vertex : mesh_.triangles.reshaped()) used[vertex] = true;
    const auto isolated = std::ranges::count(used, false);
    if (isolated == 0) return;
    const auto first = static_cast<int>(std::ranges::find(used, false) - used.begin());
    const std::string more = isolated > 1 ? fmt::format(", nor do {} others", isolated - 1) : "";
    add(numbering_.line_of_vertex(first),
        fmt::format("vertex {} belongs to no triangle{}", numbering_.shown(first), more),
        "only vertices of faces: others would have no mass");
  }

  const TriangleMesh& mesh_;
  const MeshNumbering& numbering_;
  std::vector<MeshProblem> problems_;
};

double angle_at(const Eigen::Matrix<double, 2, 3>& corners, int k) {
  const Eigen::Vector2d a = corners.col((k + 1) % 3) - corners.col(k);
  const Eigen::Vector2d b = corners.col((k + 2) % 3) - corners.col(k);
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

}  // namespace

std::vector<MeshProblem> find_mesh_problems(const TriangleMesh& mesh,
                                            const MeshNumbering& numbering) {
  return MeshInspector(mesh, numbering).inspect();
}

void require_good_mesh(const TriangleMesh& mesh, const MeshNumbering& numbering) {
  const std::vector<MeshProblem> problems = find_mesh_problems(mesh, numbering);
  if (problems.empty()) return;
  std::string text = problems[0].text;
  const std::size_t others = problems.size() - 1;
  if (others > 0) {
    text += fmt::format(" (and {}{} more problem{})", others,
                        problems.size() == kMaxMeshProblems ? " or" : "", others == 1 ? "" : "s");
  }
  throw InputError({numbering.file, problems[0].line}, text, problems[0].expected);
}

MeshQuality mesh_quality(const TriangleMesh& mesh) {
  PLIANT_ASSERT(mesh.triangle_count() > 0, "a mesh with triangles");
  MeshQuality quality;
  quality.shortest_edge = std::numeric_limits<double>::max();
  quality.smallest_angle = std::numbers::pi;
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(t);
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      const double edge = (corners.col((k + 1) % 3) - corners.col(k)).norm();
      longest = std::max(longest, edge);
      quality.shortest_edge = std::min(quality.shortest_edge, edge);
      sum += edge;
      const double angle = angle_at(corners, k);
      if (angle < quality.smallest_angle) {
        quality.smallest_angle = angle;
        quality.smallest_angle_triangle = t;
      }
      if (angle > quality.largest_angle) {
        quality.largest_angle = angle;
        quality.largest_angle_triangle = t;
      }
    }
    quality.longest_edge = std::max(quality.longest_edge, longest);
    const double height = 2 * std::abs(rest_area(mesh, t)) / longest;
    const double ratio = std::sqrt(0.75) * longest / height;
    if (ratio > quality.largest_aspect_ratio) {
      quality.largest_aspect_ratio = ratio;
      quality.largest_aspect_ratio_triangle = t;
    }
  }
  quality.mean_edge = sum / (3.0 * mesh.triangle_count());
  return quality;
}

}  // namespace pliant
