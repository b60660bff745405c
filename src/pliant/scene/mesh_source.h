#pragma once

#include <filesystem>
#include <variant>

#include "pliant/base/errors.h"
#include "pliant/geometry/mesh_file.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/io/fields.h"

namespace pliant {

/// A mesh in a file.
struct FileMesh {
  std::filesystem::path file;
  MeshFileOptions options;
};

/// A regular grid of a rectangle, from (0, 0) to (width, height) in the plane z = 0.
struct GridMesh {
  double width = 0, height = 0;  ///< m
  int nodes_u = 0, nodes_v = 0;  ///< vertices along weft and along warp
  Diagonals diagonals = Diagonals::alternating;
};

/// An irregular mesh of such a rectangle.
struct RectangleMesh {
  double width = 0, height = 0;  ///< m
  double edge = 0;               ///< length that edges aim at, m
};

/// A regular grid that is sewn to a tube about the z axis, which stands on z = 0.
struct TubeMesh {
  double circumference = 0, length = 0;   ///< m, along weft and along warp
  int nodes_around = 0, nodes_along = 0;  ///< vertices
  Diagonals diagonals = Diagonals::alternating;
};

/// How a cloth comes by its mesh.
struct MeshSource {
  std::variant<FileMesh, GridMesh, RectangleMesh, TubeMesh> kind;
  Location where;

  /// Whether the cloth is a rectangle, so that it has named edges and corners.
  bool is_rectangle() const {
    return std::holds_alternative<GridMesh>(kind) || std::holds_alternative<RectangleMesh>(kind);
  }
};

/// `{file, unit, up, rest, uv_scale}`, `{grid, nodes, diagonals}`, `{rectangle, edge}` or
/// `{tube, nodes, diagonals}`.
/// @throws InputError, also for a file that does not exist; its content is not looked at
MeshSource read_mesh_source(const Value& value);

}  // namespace pliant
