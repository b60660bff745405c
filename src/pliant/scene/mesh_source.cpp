#include "pliant/scene/mesh_source.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/geometry/mesh_file_fields.h"
#include "pliant/io/named_file.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

constexpr int kMostNodesAlong = 100'000;
constexpr double kMostVertices = 1e7;

void require_countable(const Value& value, double vertices) {
  if (vertices <= kMostVertices) return;
  value.fail(fmt::format("makes about {:.2g} vertices", vertices),
             fmt::format("at most {:.0f}", kMostVertices));
}

/// Only OBJ files hold texture coordinates.
bool may_have_uv(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".obj" || extension == ".OBJ";
}

FileMesh read_file_mesh(const Value& file, Fields& fields) {
  FileMesh mesh;
  mesh.file = read_named_file(file, "a mesh file");
  MeshFileOptions& options = mesh.options;
  options.unit = read_file_unit(fields);
  options.up = read_file_up(fields).value_or(options.up);
  options.rest = may_have_uv(mesh.file) ? RestShape::uv : RestShape::shape;
  if (auto v = fields.optional("rest")) {
    options.rest = v->choice({"uv", "shape"}) == "uv" ? RestShape::uv : RestShape::shape;
  }
  if (auto v = fields.optional("uv_scale")) {
    options.uv_scale = v->positive_quantity(Dimension::length);
    if (options.rest != RestShape::uv) v->fail("is of no use with `rest: shape`", "`rest: uv`");
  }
  return mesh;
}

Diagonals read_diagonals(Fields& fields) {
  const auto value = fields.optional("diagonals");
  const std::string name =
      value ? value->choice({"alternate", "rising", "falling"}) : std::string("alternate");
  if (name == "alternate") return Diagonals::alternating;
  return name == "rising" ? Diagonals::rising : Diagonals::falling;
}

GridMesh read_grid(const Value& grid, Fields& fields) {
  GridMesh mesh;
  std::tie(mesh.width, mesh.height) = read_extents(grid);
  const Value nodes = fields.require("nodes");
  std::tie(mesh.nodes_u, mesh.nodes_v) = read_counts(nodes, 2, kMostNodesAlong);
  require_countable(nodes, static_cast<double>(mesh.nodes_u) * mesh.nodes_v);
  mesh.diagonals = read_diagonals(fields);
  return mesh;
}

TubeMesh read_tube(const Value& tube, Fields& fields) {
  constexpr int kFewestAround = 3;
  TubeMesh mesh;
  std::tie(mesh.circumference, mesh.length) = read_extents(tube);
  const Value nodes = fields.require("nodes");
  std::tie(mesh.nodes_around, mesh.nodes_along) = read_counts(nodes, 2, kMostNodesAlong);
  require_countable(nodes, static_cast<double>(mesh.nodes_around) * mesh.nodes_along);
  if (mesh.nodes_around < kFewestAround) {
    nodes.fail("makes no tube", "at least 3 vertices around it");
  }
  mesh.diagonals = read_diagonals(fields);
  if (mesh.diagonals == Diagonals::alternating && mesh.nodes_around % 2 != 0) {
    nodes.fail("is odd around the tube, where diagonals alternate",
               "an even number around it, or `diagonals: rising`");
  }
  return mesh;
}

RectangleMesh read_rectangle(const Value& rectangle, Fields& fields) {
  RectangleMesh mesh;
  std::tie(mesh.width, mesh.height) = read_extents(rectangle);
  const Value edge = fields.require("edge");
  mesh.edge = edge.positive_quantity(Dimension::length);
  if (mesh.edge > std::min(mesh.width, mesh.height)) {
    edge.fail("is longer than a side of the rectangle", "a length of edges within it");
  }
  // An equilateral triangulation has a vertex for each 0.87 edge^2.
  require_countable(edge, mesh.width * mesh.height / (0.87 * mesh.edge * mesh.edge));
  return mesh;
}

}  // namespace

MeshSource read_mesh_source(const Value& value) {
  Fields fields = value.fields();
  MeshSource source;
  source.where = value.location();
  const auto file = fields.optional("file"), grid = fields.optional("grid");
  const auto rectangle = fields.optional("rectangle"), tube = fields.optional("tube");
  if (static_cast<int>(file.has_value()) + static_cast<int>(grid.has_value()) +
          static_cast<int>(rectangle.has_value()) + static_cast<int>(tube.has_value()) !=
      1) {
    value.fail("is not one mesh", "one of `file`, `grid`, `rectangle` and `tube`");
  }
  if (file) source.kind = read_file_mesh(*file, fields);
  if (grid) source.kind = read_grid(*grid, fields);
  if (rectangle) source.kind = read_rectangle(*rectangle, fields);
  if (tube) source.kind = read_tube(*tube, fields);
  fields.finish();
  return source;
}

}  // namespace pliant
