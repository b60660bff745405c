#include "pliant/scene/cloth_mesh.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/plausibility.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/mesh_file.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/geometry/tube.h"

namespace pliant {
namespace {

ClothMesh make_mesh(const FileMesh& source) {
  MeshFile file = read_mesh_file(source.file, source.options);
  return {std::move(file.mesh), std::move(file.numbering), std::move(file.warnings)};
}

ClothMesh make_mesh(const GridMesh& grid) {
  return {
      regular_grid(grid.width, grid.height, grid.nodes_u, grid.nodes_v, grid.diagonals), {}, {}};
}

ClothMesh make_mesh(const RectangleMesh& rectangle) {
  return {irregular_rectangle(rectangle.width, rectangle.height, rectangle.edge), {}, {}};
}

ClothMesh make_mesh(const TubeMesh& source) {
  return {tube(source.circumference, source.length, source.nodes_around, source.nodes_along,
               source.diagonals),
          {},
          {}};
}

/// The region of each face: 0 for none, else 1 + its number.
std::vector<int> region_of_faces(const SceneCloth& cloth, int face_count) {
  std::vector<int> region_of(static_cast<std::size_t>(face_count), 0);
  for (std::size_t r = 0; r < cloth.regions.size(); ++r) {
    const IndexList& faces = cloth.regions[r].faces;
    for (const int face : numbers_of(faces, face_count, "face")) {
      int& region = region_of[static_cast<std::size_t>(face)];
      if (region != 0) {
        throw InputError(faces.where, fmt::format("face {} is listed twice", face),
                         "each face in one region, once");
      }
      region = 1 + static_cast<int>(r);
    }
  }
  return region_of;
}

// What the size of a cloth goes with.
Plausibility::Reading size_of(const FileMesh& source, Plausibility& cloth) {
  const MeshFileOptions& options = source.options;
  const bool by_texture = options.rest == RestShape::uv && options.uv_scale;
  return by_texture ? cloth.field("uv_scale", Dimension::length, *options.uv_scale)
                    : cloth.field("unit", Dimension::length, options.unit);
}

Plausibility::Reading size_of(const GridMesh& grid, Plausibility& cloth) {
  return cloth.field("grid", Dimension::length, grid.width);
}

Plausibility::Reading size_of(const RectangleMesh& rectangle, Plausibility& cloth) {
  return cloth.field("rectangle", Dimension::length, rectangle.width);
}

Plausibility::Reading size_of(const TubeMesh& tube, Plausibility& cloth) {
  return cloth.field("tube", Dimension::length, tube.circumference);
}

template <class Source>
ClothMesh make_and_judge(const Source& source) {
  ClothMesh made = make_mesh(source);
  Plausibility cloth;
  cloth.add(figures::kArea, rest_area(made.mesh), {{size_of(source, cloth), 2}});
  if (auto question = cloth.question()) made.warnings.push_back(std::move(*question));
  return made;
}

}  // namespace

ClothMesh make_cloth_mesh(const MeshSource& source) {
  try {
    return std::visit([](const auto& kind) { return make_and_judge(kind); }, source.kind);
  } catch (const InputError& error) {
    // What is not about a file is about what the scene asks for.
    if (!error.where().file.empty()) throw;
    throw InputError(source.where, error.problem(), error.expected());
  }
}

std::vector<int> material_of_triangles(const SceneCloth& cloth, const ClothMesh& mesh) {
  const int triangles = mesh.mesh.triangle_count();
  int face_count = 0;
  for (int t = 0; t < triangles; ++t) {
    face_count = std::max(face_count, mesh.numbering.face_of(t) + 1);
  }
  const std::vector<int> region_of = region_of_faces(cloth, face_count);
  std::vector<int> materials;
  materials.reserve(static_cast<std::size_t>(triangles));
  for (int t = 0; t < triangles; ++t) {
    materials.push_back(region_of[static_cast<std::size_t>(mesh.numbering.face_of(t))]);
  }
  return materials;
}

}  // namespace pliant
