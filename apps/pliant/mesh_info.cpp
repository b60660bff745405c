#include "apps/pliant/mesh_info.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/geometry/mesh_file.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

std::string number(double value) { return format_number(value, kInfoDigits); }

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

void add_counts(const PolygonMesh& polygons, const TriangleMesh& mesh, FileInfo& info) {
  std::map<std::size_t, int> sizes;
  for (std::size_t i = 0; i < polygons.faces.size(); ++i) ++sizes[polygons.faces[i].size()];
  std::vector<std::string> texts;
  Json faces = Json::object();
  for (const auto& [corners, count] : sizes) {
    faces[std::to_string(corners)] = count;
    texts.push_back(fmt::format("{} of {} corners", count, corners));
  }
  info.json["vertices"] = mesh.vertex_count();
  info.json["faces"] = polygons.faces.size();
  info.json["faces_by_corners"] = std::move(faces);
  info.json["triangles"] = mesh.triangle_count();
  info.lines.push_back(labelled("vertices", fmt::format("{}", mesh.vertex_count())));
  info.lines.push_back(
      labelled("faces", fmt::format("{} ({})", polygons.faces.size(), fmt::join(texts, ", "))));
  info.lines.push_back(labelled("triangles", fmt::format("{}", mesh.triangle_count())));
}

void add_extents(const PolygonMesh& polygons, FileInfo& info) {
  const Eigen::Vector3d low = polygons.positions.rowwise().minCoeff();
  const Eigen::Vector3d high = polygons.positions.rowwise().maxCoeff();
  info.json["unit"] = nullptr;
  info.json["min"] = low;
  info.json["max"] = high;
  info.lines.push_back(labelled("unit of length", "not told by the file; what follows is in it"));
  for (int axis = 0; axis < 3; ++axis) {
    info.lines.push_back(labelled(std::string(1, "xyz"[axis]),
                                  fmt::format("{} to {}", number(low[axis]), number(high[axis])),
                                  1));
  }
}

void add_shape(const TriangleMesh& mesh, FileInfo& info) {
  const double area = compare_areas(mesh).space;
  const bool flat = lay_out_shape(mesh.positions, mesh.triangles).flat;
  info.json["area"] = area;
  info.json["flat"] = flat;
  info.lines.push_back(labelled("area", number(area)));
  info.lines.push_back(
      labelled("rest area by its shape", flat ? number(rest_area(mesh)) : "the mesh is not flat"));
}

/// Area by texture coordinates; NaN where a corner has none.
double texture_area(const PolygonMesh& polygons) {
  double area = 0;
  const CutFaces cut =
      cut_into_triangles(polygons.faces, face_planes(polygons), polygons.numbering);
  for (const auto& corners : cut.corners.colwise()) {
    const Eigen::Vector2d origin = polygons.texture.col(corners[0]);
    const Eigen::Vector2d a = polygons.texture.col(corners[1]) - origin;
    const Eigen::Vector2d b = polygons.texture.col(corners[2]) - origin;
    area += std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

/// Whether the texture coordinates can be the rest shape, at the scale that makes areas equal.
void add_texture(const PolygonMesh& polygons, const TriangleMesh& mesh, FileInfo& info) {
  info.json["texture"] = nullptr;
  if (!polygons.has_texture()) {
    info.lines.push_back(labelled("texture coordinates", "none"));
    return;
  }
  const double area = texture_area(polygons);
  const double scale = std::sqrt(compare_areas(mesh).space / area);
  Json json{{"area", area}, {"matching_uv_scale", scale}, {"panels", nullptr}};  // NaN: null
  std::string text = fmt::format("area {}; uv_scale {} would match the area in space", number(area),
                                 number(scale));
  try {
    MeshFileOptions options{.unit = 1, .rest = RestShape::uv};
    if (std::isfinite(scale) && scale > 0) options.uv_scale = scale;
    const MeshFile sheet = make_sheet(polygons, options);
    const std::vector<int> panels = find_panels(sheet.mesh);
    const int count = *std::max_element(panels.begin(), panels.end()) + 1;
    json["panels"] = count;
    text += fmt::format("; {} panel{}", count, count == 1 ? "" : "s");
  } catch (const InputError& error) {
    info.warnings.push_back("the texture coordinates are no rest shape (at 1 m a unit): " +
                            error.problem());
  }
  info.json["texture"] = std::move(json);
  info.lines.push_back(labelled("texture coordinates", text));
}

Json worst_json(double value, const char* name, int face) {
  return {{name, value}, {"face", face}};
}

void add_quality(const MeshFile& sheet, FileInfo& info) {
  const MeshQuality quality = mesh_quality(sheet.mesh);
  const auto face = [&](int triangle) {
    return sheet.numbering.shown(sheet.numbering.face_of(triangle));
  };
  const int small = face(quality.smallest_angle_triangle);
  const int large = face(quality.largest_angle_triangle);
  const int thin = face(quality.largest_aspect_ratio_triangle);
  info.json["edges"] = {{"shortest", quality.shortest_edge},
                        {"mean", quality.mean_edge},
                        {"longest", quality.longest_edge}};
  info.json["smallest_angle"] = worst_json(quality.smallest_angle, "rad", small);
  info.json["largest_angle"] = worst_json(quality.largest_angle, "rad", large);
  info.json["largest_aspect_ratio"] = worst_json(quality.largest_aspect_ratio, "ratio", thin);
  info.lines.push_back(
      labelled("edges", fmt::format("{} to {}, mean {}", number(quality.shortest_edge),
                                    number(quality.longest_edge), number(quality.mean_edge))));
  info.lines.push_back(labelled(
      "angles",
      fmt::format("{:.1f} deg (face {}) to {:.1f} deg (face {})", degrees(quality.smallest_angle),
                  small, degrees(quality.largest_angle), large)));
  info.lines.push_back(labelled(
      "worst aspect ratio",
      fmt::format("{} (face {}; equilateral 1)", number(quality.largest_aspect_ratio), thin)));
}

/// Topology of a mesh without problems: others have none to speak of.
void add_boundary(const TriangleMesh& mesh, FileInfo& info) {
  const std::vector<MeshEdge> edges = find_edges(mesh.triangles);
  const auto boundary = std::count_if(edges.begin(), edges.end(),
                                      [](const MeshEdge& edge) { return edge.is_boundary(); });
  info.json["boundary_edges"] = boundary;
  info.lines.push_back(
      labelled("boundary", boundary == 0 ? "none: a closed surface"
                                         : fmt::format("{} of {} edges", boundary, edges.size())));
}

}  // namespace

FileInfo mesh_info(const std::filesystem::path& path) {
  const PolygonMesh polygons = read_polygon_mesh(path);
  const MeshFile sheet = make_sheet(polygons, {.unit = 1});
  FileInfo info = begin_info(path, "mesh");
  add_counts(polygons, sheet.mesh, info);
  add_extents(polygons, info);
  add_shape(sheet.mesh, info);
  add_texture(polygons, sheet.mesh, info);
  add_quality(sheet, info);
  const std::vector<MeshProblem> problems = find_mesh_problems(sheet.mesh, sheet.numbering);
  if (problems.empty()) add_boundary(sheet.mesh, info);
  for (const MeshProblem& problem : problems) {
    const std::string line = problem.line > 0 ? fmt::format("line {}: ", problem.line) : "";
    info.warnings.push_back(fmt::format("{}{}; needed: {}", line, problem.text, problem.expected));
  }
  info.json["left_out"] = polygons.ignored;
  if (!polygons.ignored.empty()) {
    info.lines.push_back(
        labelled("left out", fmt::format("{}", fmt::join(polygons.ignored, ", "))));
  }
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
