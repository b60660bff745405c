#include "pliant/scene/vertex_selection.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

// A vertex lies on a side, and in a box, within this part of the cloth's extent: rounding.
constexpr double kOnSide = 1e-9;

SheetEdge edge_of(std::string_view name) {
  if (name == "left") return SheetEdge::left;
  if (name == "right") return SheetEdge::right;
  return name == "bottom" ? SheetEdge::bottom : SheetEdge::top;
}

SheetCorner read_corner(const Value& value) {
  const std::string name = value.choice({"bottom-left", "bottom-right", "top-left", "top-right"});
  const std::size_t dash = name.find('-');
  return {edge_of(name.substr(dash + 1)), edge_of(name.substr(0, dash))};
}

SheetEdge read_edge(const Value& value) {
  return edge_of(value.choice({"left", "right", "bottom", "top"}));
}

/// The elements of a list, which is not empty.
template <class Read>
auto read_list(const Value& list, Read read) {
  std::vector<decltype(read(list))> elements;
  for (const Value& item : list.items()) elements.push_back(read(item));
  if (elements.empty()) list.fail("is empty", "at least one");
  return elements;
}

Eigen::AlignedBox3d read_within(const Value& value) {
  Fields fields = value.fields();
  const Value node = fields.require("box");
  fields.finish();
  Fields corners = node.fields();
  const Eigen::AlignedBox3d box(read_vector(corners.require("low")),
                                read_vector(corners.require("high")));
  corners.finish();
  if (box.isEmpty()) node.fail("is empty", "a `low` that is nowhere above `high`");
  return box;
}

bool is_on(SheetEdge edge, const Eigen::Vector3d& point, const Eigen::AlignedBox3d& sheet) {
  const double tolerance = kOnSide * sheet.diagonal().norm();
  const bool across = edge == SheetEdge::left || edge == SheetEdge::right;
  const bool low = edge == SheetEdge::left || edge == SheetEdge::bottom;
  const int axis = across ? 0 : 1;
  const double side = low ? sheet.min()(axis) : sheet.max()(axis);
  return std::abs(point(axis) - side) <= tolerance;
}

bool is_selected(const VertexSelection& selection, const Eigen::Vector3d& point,
                 const Eigen::AlignedBox3d& sheet) {
  const auto on = [&](SheetEdge edge) { return is_on(edge, point, sheet); };
  if (std::any_of(selection.edges.begin(), selection.edges.end(), on)) return true;
  const auto at = [&](const SheetCorner& corner) { return on(corner.across) && on(corner.along); };
  if (std::any_of(selection.corners.begin(), selection.corners.end(), at)) return true;
  if (!selection.within) return false;
  return selection.within->exteriorDistance(point) <= kOnSide * sheet.diagonal().norm();
}

}  // namespace

VertexSelection read_vertex_selection(Fields& fields) {
  VertexSelection selection;
  selection.where = fields.location();
  const auto vertices = fields.optional("vertices"), corners = fields.optional("corners");
  const auto edges = fields.optional("edges"), within = fields.optional("within");
  if (!vertices && !corners && !edges && !within) {
    throw InputError(selection.where, "holds no vertex",
                     "`vertices`, `corners`, `edges` or `within`");
  }
  if (vertices) selection.vertices = read_index_list(*vertices);
  if (corners) selection.corners = read_list(*corners, read_corner);
  if (edges) selection.edges = read_list(*edges, read_edge);
  if (within) selection.within = read_within(*within);
  return selection;
}

std::vector<int> selected_vertices(const VertexSelection& selection,
                                   const Eigen::Matrix3Xd& positions) {
  const int count = static_cast<int>(positions.cols());
  std::set<int> selected;
  if (selection.vertices) {
    const std::vector<int> listed = numbers_of(*selection.vertices, count, "vertex");
    selected.insert(listed.begin(), listed.end());
  }
  Eigen::AlignedBox3d sheet;
  for (const auto& point : positions.colwise()) sheet.extend(Eigen::Vector3d(point));
  for (int i = 0; i < count; ++i) {
    if (is_selected(selection, positions.col(i), sheet)) selected.insert(i);
  }
  if (selected.empty()) {
    throw InputError(selection.where, "holds no vertex",
                     "a box that vertices of the cloth lie in, in its own coordinates");
  }
  return {selected.begin(), selected.end()};
}

}  // namespace pliant
