#include "pliant/scene/vertex_selection.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
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

Placed<Eigen::AlignedBox3d> read_within(const Value& value) {
  Fields fields = value.fields();
  const Value node = fields.require("box");
  fields.finish();
  Fields corners = node.fields();
  const Eigen::AlignedBox3d box(read_vector(corners.require("low")),
                                read_vector(corners.require("high")));
  corners.finish();
  if (box.isEmpty()) node.fail("is empty", "a `low` that is nowhere above `high`");
  return {box, node.location()};
}

/// A point, or a list of points.
std::vector<Placed<Eigen::Vector3d>> read_nearest(const Value& value) {
  const std::vector<Value> items = value.items();
  if (!items.empty() && items.front().is_scalar()) return {{read_vector(value), value.location()}};
  return read_list(value, [](const Value& point) {
    return Placed<Eigen::Vector3d>{read_vector(point), point.location()};
  });
}

Placed<std::string> read_group(const Value& value) { return {value.text(), value.location()}; }

bool is_on(SheetEdge edge, const Eigen::Vector3d& point, const Eigen::AlignedBox3d& sheet) {
  const double tolerance = kOnSide * sheet.diagonal().norm();
  const bool across = edge == SheetEdge::left || edge == SheetEdge::right;
  const bool low = edge == SheetEdge::left || edge == SheetEdge::bottom;
  const int axis = across ? 0 : 1;
  const double side = low ? sheet.min()(axis) : sheet.max()(axis);
  return std::abs(point(axis) - side) <= tolerance;
}

bool is_at_the_rim(const VertexSelection& selection, const Eigen::Vector3d& point,
                   const Eigen::AlignedBox3d& sheet) {
  const auto on = [&](SheetEdge edge) { return is_on(edge, point, sheet); };
  if (std::any_of(selection.edges.begin(), selection.edges.end(), on)) return true;
  const auto at = [&](const SheetCorner& corner) { return on(corner.across) && on(corner.along); };
  return std::any_of(selection.corners.begin(), selection.corners.end(), at);
}

/// "[0, 0, 0] to [0.1, 0.2, 0]", where the cloth is.
std::string extent_text(const Eigen::AlignedBox3d& cloth) {
  constexpr int kDigits = 4;
  const auto corner = [](const Eigen::Vector3d& point) {
    return fmt::format("[{}, {}, {}]", format_number(point.x(), kDigits),
                       format_number(point.y(), kDigits), format_number(point.z(), kDigits));
  };
  return corner(cloth.min()) + " to " + corner(cloth.max()) + " m in its own coordinates";
}

int nearest_vertex(const Placed<Eigen::Vector3d>& point, const Eigen::Matrix3Xd& positions,
                   const Eigen::AlignedBox3d& cloth) {
  Eigen::Index vertex = 0;
  const double distance =
      std::sqrt((positions.colwise() - point.value).colwise().squaredNorm().minCoeff(&vertex));
  if (distance > cloth.diagonal().norm()) {
    throw InputError(point.where,
                     fmt::format("is {} from the nearest vertex of the cloth",
                                 format_quantity(distance, Dimension::length)),
                     "a point of the cloth, which spans " + extent_text(cloth));
  }
  return static_cast<int>(vertex);
}

const std::vector<int>& vertices_of_group(const Placed<std::string>& group,
                                          const VertexGroups& groups) {
  std::vector<std::string> names;
  for (const auto& [name, vertices] : groups) names.push_back(name);
  const auto found = groups.find(group.value);
  if (found == groups.end()) {
    throw InputError(
        group.where,
        "the mesh has no vertex group " + quoted_value(group.value) +
            did_you_mean(group.value, names),
        names.empty() ? "a mesh file with groups: g lines in .obj, numbers of the vertices in .ply"
                      : list_of_names(names));
  }
  if (found->second.empty()) {
    throw InputError(group.where, "the vertex group " + quoted_value(group.value) + " is empty",
                     "a group with vertices");
  }
  return found->second;
}

std::vector<int> vertices_within(const Placed<Eigen::AlignedBox3d>& box,
                                 const Eigen::Matrix3Xd& positions,
                                 const Eigen::AlignedBox3d& cloth) {
  std::vector<int> vertices;
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const double distance = box.value.exteriorDistance(positions.col(i).eval());
    if (distance <= kOnSide * cloth.diagonal().norm()) vertices.push_back(static_cast<int>(i));
  }
  if (vertices.empty()) {
    throw InputError(box.where, "holds no vertex",
                     "a box with vertices of the cloth, which spans " + extent_text(cloth));
  }
  return vertices;
}

}  // namespace

VertexSelection read_vertex_selection(Fields& fields) {
  VertexSelection selection;
  selection.where = fields.location();
  const auto vertices = fields.optional("vertices"), corners = fields.optional("corners");
  const auto edges = fields.optional("edges"), within = fields.optional("within");
  const auto nearest = fields.optional("nearest"), groups = fields.optional("groups");
  if (!vertices && !corners && !edges && !nearest && !groups && !within) {
    throw InputError(selection.where, "holds no vertex",
                     "`vertices`, `corners`, `edges`, `nearest`, `groups` or `within`");
  }
  if (vertices) selection.vertices = read_index_list(*vertices);
  if (corners) selection.corners = read_list(*corners, read_corner);
  if (edges) selection.edges = read_list(*edges, read_edge);
  if (nearest) selection.nearest = read_nearest(*nearest);
  if (groups) selection.groups = read_list(*groups, read_group);
  if (within) selection.within = read_within(*within);
  return selection;
}

std::vector<int> selected_vertices(const VertexSelection& selection, const ClothVertices& cloth) {
  const Eigen::Matrix3Xd& positions = cloth.positions;
  Eigen::AlignedBox3d box;
  for (const auto& point : positions.colwise()) box.extend(Eigen::Vector3d(point));
  std::set<int> selected;
  const auto add = [&](const std::vector<int>& vertices) {
    selected.insert(vertices.begin(), vertices.end());
  };
  const int count = static_cast<int>(positions.cols());
  if (selection.vertices) add(numbers_of(*selection.vertices, count, "vertex"));
  for (const auto& group : selection.groups) add(vertices_of_group(group, cloth.groups));
  for (const auto& point : selection.nearest) add({nearest_vertex(point, positions, box)});
  if (selection.within) add(vertices_within(*selection.within, positions, box));
  for (int i = 0; i < count; ++i) {
    if (is_at_the_rim(selection, positions.col(i), box)) selected.insert(i);
  }
  return {selected.begin(), selected.end()};
}

}  // namespace pliant
