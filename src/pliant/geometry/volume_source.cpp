#include "pliant/geometry/volume_source.h"

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/label_volume.h"
#include "pliant/geometry/mesh_file_fields.h"
#include "pliant/geometry/polygon_mesh.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/geometry/volume_mesher.h"
#include "pliant/geometry/world_positions.h"
#include "pliant/io/named_file.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

constexpr int kMostCellsAlong = 10'000;
constexpr double kMostCells = 1e7;

VolumeFileSource read_volume_file(const Value& file, Fields& fields) {
  VolumeFileSource source;
  source.file = read_named_file(file, "a file of a volume mesh");
  source.unit = read_file_unit(fields);
  source.up = read_file_up(fields).value_or(source.up);
  return source;
}

std::array<int, 3> read_cells(const Value& value) {
  const std::vector<Value> items = value.items();
  if (items.size() != 3) value.fail("are not three numbers", "[along x, along y, along z]");
  std::array<int, 3> cells{};
  double count = 1;
  for (size_t a = 0; a < 3; ++a) {
    cells[a] = items[a].integer(1, kMostCellsAlong);
    count *= cells[a];
  }
  if (count > kMostCells) value.fail("make too many cells", "at most 10 million");
  return cells;
}

BlockSource read_block(const Value& block, Fields& fields) {
  BlockSource source;
  source.size = read_vector(block);
  if (source.size.minCoeff() <= 0) block.fail("has no volume", "three lengths above 0 (m)");
  source.cells = read_cells(fields.require("cells"));
  if (auto v = fields.optional("elements")) {
    source.of_tetrahedra = v->choice({"hexahedra", "tetrahedra"}) == "tetrahedra";
  }
  return source;
}

SurfaceSource read_surface(const Value& surface, Fields& fields) {
  SurfaceSource source;
  source.file = read_named_file(surface, "a mesh file of a closed surface");
  source.unit = read_file_unit(fields);
  source.up = read_file_up(fields).value_or(source.up);
  source.edge = fields.require("edge").positive_quantity(Dimension::length);
  return source;
}

LabelSource read_labels(const Value& labels, Fields& fields) {
  LabelSource source;
  source.file = read_named_file(labels, "a .nrrd file of labels");
  source.unit = read_file_unit(fields);
  source.edge = fields.require("edge").positive_quantity(Dimension::length);
  return source;
}

Fingertip read_fingertip(const Value& value, Fields& fields) {
  const Eigen::Vector3d size = read_vector(value);
  if (size.minCoeff() <= 0) value.fail("has no volume", "three lengths above 0 (m)");
  if (size.x() <= size.y() / 2) {
    value.fail("is not longer than half its width", "[length, width, height] (m)");
  }
  const Value edge = fields.require("edge");
  Fingertip shape{size.x(), size.y(), size.z(), edge.positive_quantity(Dimension::length)};
  if (shape.edge > size.minCoeff() / 3) {
    edge.fail("is too long for the body", "at most a third of its least size");
  }
  return shape;
}

VolumeMesh make_mesh(const Fingertip& shape) {
  VolumeMesh mesh = make_fingertip(shape);
  require_good_volume_mesh(mesh, {});
  return mesh;
}

VolumeMesh make_mesh(const SurfaceSource& source) {
  const PolygonMesh polygons = read_polygon_mesh(source.file);
  const CutFaces cut =
      cut_into_triangles(polygons.faces, face_planes(polygons), polygons.numbering);
  const Eigen::Matrix3Xi triangles =
      cut.corners.unaryExpr([&](int corner) { return polygons.faces.corners[corner]; });
  const Eigen::Matrix3Xd positions = world_positions(polygons, source.unit, source.up);
  VolumeMesh mesh = fill_surface(positions, triangles, source.edge, source.file.string());
  require_good_volume_mesh(mesh, {.file = source.file.string()});
  return mesh;
}

VolumeMesh make_mesh(const LabelSource& source) {
  LabelVolume volume = read_label_volume(source.file);
  volume.axes *= source.unit;
  volume.origin *= source.unit;
  VolumeMesh mesh = fill_labels(volume, source.edge, source.file.string());
  require_good_volume_mesh(mesh, {.file = source.file.string()});
  return mesh;
}

VolumeMesh make_mesh(const VolumeFileSource& source) {
  return read_volume_mesh(source.file, {source.unit, source.up});
}

VolumeMesh make_mesh(const BlockSource& source) {
  return source.of_tetrahedra ? block_of_tetrahedra(source.size, source.cells)
                              : block_of_hexahedra(source.size, source.cells);
}

}  // namespace

VolumeSource read_volume_source(const Value& value) {
  Fields fields = value.fields();
  VolumeSource source;
  source.where = value.location();
  const auto file = fields.optional("file"), block = fields.optional("block");
  const auto surface = fields.optional("surface"), fingertip = fields.optional("fingertip");
  const auto labels = fields.optional("labels");
  if (file.has_value() + block.has_value() + surface.has_value() + labels.has_value() +
          fingertip.has_value() !=
      1) {
    value.fail("is not one mesh", "`file`, `block`, `surface`, `labels` or `fingertip`");
  }
  if (file) source.kind = read_volume_file(*file, fields);
  if (block) source.kind = read_block(*block, fields);
  if (surface) source.kind = read_surface(*surface, fields);
  if (labels) source.kind = read_labels(*labels, fields);
  if (fingertip) source.kind = read_fingertip(*fingertip, fields);
  fields.finish();
  return source;
}

std::filesystem::path VolumeSource::file() const {
  if (const auto* mesh = std::get_if<VolumeFileSource>(&kind)) return mesh->file;
  if (const auto* surface = std::get_if<SurfaceSource>(&kind)) return surface->file;
  if (const auto* labels = std::get_if<LabelSource>(&kind)) return labels->file;
  return {};
}

VolumeMesh make_volume_mesh(const VolumeSource& source) {
  return std::visit([](const auto& kind) { return make_mesh(kind); }, source.kind);
}

}  // namespace pliant
