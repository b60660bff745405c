#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/mesh_numbering.h"
#include "pliant/io/mesh_data.h"

namespace pliant {

/// A mesh of polygons as it stands in a file, in the file's unit and axes.
struct PolygonMesh {
  MeshNumbering numbering;     ///< `faces` is empty
  Eigen::Matrix3Xd positions;  ///< one column a vertex
  Polygons faces;
  /// Texture coordinates, one column for each corner of `faces`, NaN for a corner without; no
  /// columns when the file has none.
  Eigen::Matrix2Xd texture;
  std::vector<std::string> ignored;  ///< what the file holds besides, in words

  bool has_texture() const { return texture.cols() > 0; }
};

/// Whether the name ends like one of a mesh file that `read_polygon_mesh` takes (.obj, .ply).
bool is_mesh_file(const std::filesystem::path& path);

/// @throws InputError, also for a file without faces
PolygonMesh read_polygon_mesh(const std::filesystem::path& path);

/// The triangles that faces were cut into.
struct CutFaces {
  Eigen::Matrix3Xi corners;  ///< numbers of corners of the Polygons, one column a triangle
  std::vector<int> faces;    ///< of each triangle
};

/// Cuts every face into triangles that share one corner of it: the first corner for which none of
/// them is degenerate.
/// @param plane  where to cut: coordinates of each corner in a plane of its face
/// @param numbering  of the faces, for errors
/// @throws InputError for a face of four or more corners that is not convex in its plane
CutFaces cut_into_triangles(const Polygons& faces, const Eigen::Matrix2Xd& plane,
                            const MeshNumbering& numbering);

/// The corners of each face in the plane that fits it best, with any direction of its axes.
Eigen::Matrix2Xd face_planes(const PolygonMesh& mesh);

}  // namespace pliant
