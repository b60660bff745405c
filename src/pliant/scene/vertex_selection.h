#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "pliant/base/errors.h"
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

/// The vertices of a cloth that a pin or clip holds: those of every criterion that is given.
struct VertexSelection {
  std::optional<IndexList> vertices;
  std::vector<SheetCorner> corners;           ///< of grids and rectangles
  std::vector<SheetEdge> edges;               ///< of grids and rectangles
  std::optional<Eigen::AlignedBox3d> within;  ///< closed; in the cloth's own coordinates, m
  Location where;
};

/// Reads the keys `vertices`, `corners`, `edges` and `within`, of which at least one must be given.
/// @throws InputError
VertexSelection read_vertex_selection(Fields& fields);

/// The vertices' numbers, sorted, each once.
/// @param positions  of the mesh, before the cloth is shaped and placed (m)
/// @throws InputError for a vertex that is not there, and where nothing is selected
std::vector<int> selected_vertices(const VertexSelection& selection,
                                   const Eigen::Matrix3Xd& positions);

}  // namespace pliant
