#pragma once

#include <map>
#include <string>
#include <vector>

namespace pliant {

/// Numbers of vertices by the name that a file has for them, rising.
using VertexGroups = std::map<std::string, std::vector<int>>;

/// How the owner of a mesh finds its vertices and triangles again: as faces of a file.
struct MeshNumbering {
  std::string file = {};  ///< empty for a mesh that was made
  int first = 0;          ///< number of the first vertex and the first face: 1 in OBJ, 0 elsewhere
  std::vector<int> faces = {};  ///< face of each triangle, from 0; empty: each triangle is a face
  std::vector<int> face_lines = {};    ///< line of each face in a text file; empty in a binary one
  std::vector<int> vertex_lines = {};  ///< the same of each vertex
  /// `g` lines of OBJ; properties of the vertices in PLY, with the vertices where they are not 0.
  VertexGroups groups = {};

  int face_of(int triangle) const { return faces.empty() ? triangle : faces[triangle]; }
  int line_of_face(int face) const { return face_lines.empty() ? 0 : face_lines[face]; }
  int line_of(int triangle) const { return line_of_face(face_of(triangle)); }
  int line_of_vertex(int vertex) const { return vertex_lines.empty() ? 0 : vertex_lines[vertex]; }
  /// The number of a vertex or face as the file counts it.
  int shown(int index) const { return first + index; }
};

}  // namespace pliant
