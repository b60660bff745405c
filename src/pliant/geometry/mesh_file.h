#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/geometry/mesh_numbering.h"
#include "pliant/geometry/polygon_mesh.h"
#include "pliant/geometry/rest_shape.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// What a mesh file does not say about itself.
struct MeshFileOptions {
  double unit = 0;       ///< m per unit of the file's coordinates; must be given
  std::string up = "z";  ///< the axis of the file that becomes the world's z: x, -x, y, -y, z, -z
  RestShape rest = RestShape::shape;
  std::optional<double> uv_scale = {};  ///< m per unit of the texture coordinates; else as `unit`
};

/// A triangle mesh made from the faces of a file.
struct MeshFile {
  TriangleMesh mesh;
  MeshNumbering numbering;
  std::vector<std::string> warnings;  ///< what the user should know, one line each
};

/// Makes a sheet of the faces of a file.
///
/// The file is turned as `world_positions` has it. Vertices keep their numbers. Faces of more than
/// three corners are cut into triangles, in the rest plane with `rest: uv` and in their own plane
/// else. Where all faces run clockwise at rest, their corners are reversed, so that weft and warp
/// keep their directions and the sheet's front becomes its back.
/// @throws InputError
///  - for options that are missing or do not fit the file, and faces that are not convex;
///  - with `rest: uv`, where some faces run clockwise and others do not, and where the areas at
///    rest and in space differ by a factor of more than 2 over all faces, or of more than 4 over a
///    panel: the texture coordinates are packed or scaled
MeshFile make_sheet(const PolygonMesh& polygons, const MeshFileOptions& options);

/// The sheet of a file (.obj, .ply), fit for simulation.
/// @throws InputError as read_polygon_mesh, make_sheet and require_good_mesh
MeshFile read_mesh_file(const std::filesystem::path& path, const MeshFileOptions& options);

}  // namespace pliant
