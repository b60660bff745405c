#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/ply.h"
#include "pliant/io/ply_body.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

/// A list property of all rows of an element.
struct PlyLists {
  std::vector<double> values;
  std::vector<std::size_t> ends;  // of each row in `values`
};

/// What an element holds, property by property.
struct ElementData {
  int first_line = 0;                        // of an ASCII file; 0 in a binary one
  std::vector<std::vector<double>> scalars;  // empty for lists
  std::vector<PlyLists> lists;               // empty for scalars
};

void read_list(const PlyProperty& property, PlyBody& body, PlyLists& lists) {
  const double count = body.next(*property.count_type);
  if (count < 0 || count > static_cast<double>(body.max_count(property.type))) {
    body.fail(fmt::format("a list of {} numbers ({}) does not fit in", count, property.name), {});
  }
  for (auto i = static_cast<std::size_t>(count); i > 0; --i) {
    lists.values.push_back(body.next(property.type));
  }
  lists.ends.push_back(lists.values.size());
}

ElementData read_element(const PlyElement& element, PlyBody& body) {
  ElementData data;
  data.first_line = body.next_line();
  data.scalars.resize(element.properties.size());
  data.lists.resize(element.properties.size());
  for (std::size_t row = 0; row < element.count; ++row) {
    body.begin_row(element, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count_type) {
        read_list(property, body, data.lists[i]);
      } else {
        data.scalars[i].push_back(body.next(property.type));
      }
    }
    body.end_row();
  }
  return data;
}

/// Puts the elements together to a mesh.
class MeshBuilder {
 public:
  MeshBuilder(const std::string& file, PlyPositions positions)
      : file_(file), positions_(positions) {}

  void take_vertices(const PlyElement& element, ElementData data) {
    mesh_.positions.resize(element.count);
    for (int axis = 0; axis < 3; ++axis) take_coordinate(axis, element, data);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (axis_of(property) < 0) take_column(element, i, data, mesh_.vertex_columns);
    }
    vertex_count_ = static_cast<int>(element.count);
  }

  void take_faces(const PlyElement& element, ElementData data) {
    int corner_lists = 0;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.name != "vertex_indices" && property.name != "vertex_index") {
        take_column(element, i, data, mesh_.face_columns);
      } else if (property.count_type && is_integer(property.type) && corner_lists == 0) {
        take_corners(data.lists[i], data.first_line);
        ++corner_lists;
      } else {
        fail_corners(element);
      }
    }
    if (corner_lists == 0 && element.count > 0) fail_corners(element);
  }

  void ignore(std::string what) { mesh_.ignored.push_back(std::move(what)); }
  void take_comments(std::vector<std::string> comments) { mesh_.comments = std::move(comments); }

  PlyMesh finish() && { return std::move(mesh_); }

 private:
  static int axis_of(const PlyProperty& property) {
    if (property.count_type || property.name.size() != 1) return -1;
    const int axis = property.name[0] - 'x';
    return axis >= 0 && axis < 3 ? axis : -1;
  }

  void take_coordinate(int axis, const PlyElement& element, const ElementData& data) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (axis_of(element.properties[i]) != axis) continue;
      for (std::size_t row = 0; row < element.count; ++row) {
        const double value = data.scalars[i][row];
        if (positions_ == PlyPositions::finite && !std::isfinite(value)) {
          fail_row(data, element, row, "the position is not finite");
        }
        mesh_.positions[row][axis] = value;
      }
      return;
    }
    throw InputError({file_, element.line, "element vertex"},
                     fmt::format("has no property {}", "xyz"[axis]), "properties x, y and z");
  }

  void take_column(const PlyElement& element, std::size_t index, ElementData& data,
                   std::vector<PlyColumn>& columns) {
    const PlyProperty& property = element.properties[index];
    if (property.count_type) {
      ignore(fmt::format("list {} of each {}", quoted_value(property.name), element.name));
    } else {
      columns.push_back({property.name, std::move(data.scalars[index]), property.type});
    }
  }

  void take_corners(const PlyLists& lists, int first_line) {
    mesh_.faces.ends = lists.ends;
    mesh_.faces.corners.reserve(lists.values.size());
    std::size_t begin = 0;
    for (std::size_t face = 0; face < lists.ends.size(); ++face) {
      const int line = first_line == 0 ? 0 : first_line + static_cast<int>(face);
      if (lists.ends[face] - begin < 3) {
        throw InputError(ply_row_location(file_, line, "face", face),
                         fmt::format("has {} corners", lists.ends[face] - begin), "three or more");
      }
      for (; begin < lists.ends[face]; ++begin) {
        const double vertex = lists.values[begin];
        if (vertex < 0 || vertex >= vertex_count_) {
          throw InputError(ply_row_location(file_, line, "face", face),
                           fmt::format("there is no vertex {}", vertex),
                           fmt::format("numbers from 0 to {}", vertex_count_ - 1));
        }
        mesh_.faces.corners.push_back(static_cast<int>(vertex));
      }
    }
  }

  [[noreturn]] void fail_corners(const PlyElement& element) const {
    throw InputError({file_, element.line, "element face"}, "does not say which corners faces have",
                     "one property list uchar int vertex_indices");
  }

  [[noreturn]] void fail_row(const ElementData& data, const PlyElement& element, std::size_t row,
                             const std::string& problem) const {
    const int line = data.first_line == 0 ? 0 : data.first_line + static_cast<int>(row);
    throw InputError(ply_row_location(file_, line, element.name, row), problem);
  }

  const std::string& file_;
  PlyPositions positions_;
  PlyMesh mesh_;
  int vertex_count_ = 0;
};

}  // namespace

PlyMesh parse_ply(std::string_view bytes, const std::string& file, PlyPositions positions) {
  PlyHeader header = parse_ply_header(bytes, file);
  const std::unique_ptr<PlyBody> body = make_ply_body(bytes, header, file);
  std::vector<ElementData> data;
  for (const PlyElement& element : header.elements) data.push_back(read_element(element, *body));

  // Faces may stand before the vertices whose numbers they hold.
  MeshBuilder builder(file, positions);
  bool has_vertices = false;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (header.elements[i].name != "vertex") continue;
    builder.take_vertices(header.elements[i], std::move(data[i]));
    has_vertices = true;
  }
  if (!has_vertices) throw InputError({file}, "has no element vertex", "a PLY file of a mesh");
  for (std::size_t i = 0; i < data.size(); ++i) {
    const PlyElement& element = header.elements[i];
    if (element.name == "face") {
      builder.take_faces(element, std::move(data[i]));
    } else if (element.name != "vertex") {
      builder.ignore(fmt::format("element {} ({})", quoted_value(element.name), element.count));
    }
  }
  if (body->bytes_left() > 0) {
    builder.ignore(fmt::format("{} bytes behind the last element", body->bytes_left()));
  }
  builder.take_comments(std::move(header.comments));
  return std::move(builder).finish();
}

PlyMesh read_ply(const std::filesystem::path& path, PlyPositions positions) {
  return parse_ply(read_text_file(path, kMaxMeshFileSize), path.string(), positions);
}

}  // namespace pliant
