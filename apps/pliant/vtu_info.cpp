#include <fmt/format.h>

#include "pliant/io/vtu.h"

#include "apps/pliant/file_info.h"

namespace pliant {

FileInfo vtu_info(const std::filesystem::path& path) {
  const VtuHead head = read_vtu_head(path);
  FileInfo info = begin_info(path, "VTK unstructured grid");
  info.json["vertices"] = head.points;
  info.json["cells"] = head.cells;
  info.json["fields"] = Json::array();
  info.lines.push_back(
      labelled("mesh", fmt::format("{} vertices, {} cells", head.points, head.cells)));
  if (head.fields.empty()) info.lines.push_back(labelled("fields", "none"));
  for (const VtuField& field : head.fields) {
    const char* where = field.of_points ? "vertex" : "cell";
    info.json["fields"].push_back(
        {{"name", field.name}, {"of", where}, {"components", field.components}});
    info.lines.push_back(
        labelled("field " + field.name, fmt::format("{} number{} a {}", field.components,
                                                    field.components == 1 ? "" : "s", where)));
  }
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
