#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/io/mesh_data.h"

namespace pliant {

/// What a Wavefront OBJ file says about a mesh.
struct ObjMesh {
  std::vector<Point3> positions;
  std::vector<Point2> texture_points;
  Polygons faces;  ///< corners are numbers of positions
  /// For each corner of `faces` the number of its texture point, counted from 0, -1 where it has
  /// none; empty when no face has any.
  std::vector<int> texture_corners;
  std::vector<int> face_lines;    ///< where each face stands, counted from 1; empty when not read
  std::vector<int> vertex_lines;  ///< the same of each position
  /// The vertices of the faces and points below each `g` line, by its names; rising.
  std::map<std::string, std::vector<int>> groups;
  /// After reading: statements that were left out (normals, materials, ...) and how often.
  std::map<std::string, int> ignored;
};

/// Reads the statements v, vt, f, p and g: corners as `v`, `v/vt`, `v//vn` or `v/vt/vn`, numbers
/// counted from 1 or backwards from -1, any number of corners, lines continued with a backslash.
/// Weights and colours behind a position's x, y, z and a texture point's third coordinate are left
/// out, as is every other statement.
/// @throws InputError with the line
ObjMesh read_obj(const std::filesystem::path& path);
ObjMesh parse_obj(std::string_view text, const std::string& file);

/// The text of an OBJ file; `read_obj` gives back the same bits.
std::string write_obj(const ObjMesh& mesh);

}  // namespace pliant
