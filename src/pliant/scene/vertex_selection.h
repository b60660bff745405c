#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "pliant/base/errors.h"
#include "pliant/geometry/mesh_numbering.h"
#include "pliant/io/fields.h"
#include "pliant/io/index_list.h"

namespace pliant {

/// The sides of a rectangular cloth: u = 0, u = width, v = 0, v = height.
enum class SheetEdge { left, right, bottom, top };

/// A corner of a rectangular cloth as the two sides that meet there.
struct SheetCorner {
  SheetEdge across = SheetEdge::left;   ///< left or right
  SheetEdge along = SheetEdge::bottom;  ///< bottom or top
};

/// The vertices of a cloth, to select among.
struct ClothVertices {
  Eigen::Matrix3Xd positions;  ///< before the cloth is shaped and placed (m)
  VertexGroups groups = {};    ///< of its mesh file
};

/// Something of a document with its place.
template <typename T>
struct Placed {
  T value;
  Location where;
};

/// The vertices of a cloth that a pin or clip holds: those of every criterion that is given.
struct VertexSelection {
  std::optional<IndexList> vertices;
  std::vector<SheetCorner> corners;                   ///< of grids and rectangles
  std::vector<SheetEdge> edges;                       ///< of grids and rectangles
  std::vector<Placed<Eigen::Vector3d>> nearest;       ///< points in the cloth's own coordinates, m
  std::vector<Placed<std::string>> groups;            ///< of mesh files
  std::optional<Placed<Eigen::AlignedBox3d>> within;  ///< closed; in its own coordinates, m
  Location where;
};

/// Reads the keys `vertices`, `corners`, `edges`, `nearest`, `groups` and `within`, of which at
/// least one must be given.
/// @throws InputError
VertexSelection read_vertex_selection(Fields& fields);

/// The vertices' numbers, sorted, each once.
/// @throws InputError for a vertex or group that is not there, a group or box without vertices, and
///         a point farther from the cloth than the cloth is large
std::vector<int> selected_vertices(const VertexSelection& selection, const ClothVertices& cloth);

}  // namespace pliant
