#include "pliant/experiment/body_fields.h"

#include <array>
#include <set>

#include <fmt/format.h>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/geometry/mesh_file_fields.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/geometry/volume_regions.h"
#include "pliant/io/named_file.h"

namespace pliant {
namespace {

constexpr std::array kSides{"-x", "+x", "-y", "+y", "-z", "+z"};

std::vector<int> nodes_of_side(const VolumeMesh& mesh, const Eigen::Vector3d& outwards) {
  Eigen::Index axis = 0;
  outwards.cwiseAbs().maxCoeff(&axis);
  const auto coordinates = mesh.positions.row(axis);
  const double side = outwards(axis) > 0 ? coordinates.maxCoeff() : coordinates.minCoeff();
  return nodes_at(mesh, static_cast<int>(axis), side);
}

std::vector<int> nodes_of_region(const VolumeMesh& mesh, const std::string& name) {
  std::set<int> nodes;
  for (const auto& [label, elements] : elements_of_regions(mesh)) {
    if (name_of_region(mesh, label) != name) continue;
    for (const int e : elements) {
      for (const int node : mesh.nodes_of(e)) nodes.insert(node);
    }
  }
  return {nodes.begin(), nodes.end()};
}

}  // namespace

std::optional<Eigen::Vector3d> side_named(std::string_view name) {
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (name != kSides[i]) continue;
    return (i % 2 == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i / 2));
  }
  return std::nullopt;
}

std::vector<int> read_body_nodes(const Value& value, const VolumeMesh& mesh) {
  const std::string name = value.text();
  if (const auto side = side_named(name)) return nodes_of_side(mesh, *side);
  const auto group = mesh.groups.find(name);
  if (group != mesh.groups.end()) return group->second;
  std::vector<int> nodes = nodes_of_region(mesh, name);
  if (!nodes.empty()) return nodes;
  std::vector<std::string> names;
  for (const auto& [known, of_group] : mesh.groups) names.push_back(known);
  for (const auto& [label, known] : mesh.region_names) names.push_back(known);
  for (const char* side : kSides) names.emplace_back(side);
  value.fail("the mesh has no nodes of " + quoted_value(name) + did_you_mean(name, names),
             list_of_names(names));
}

VolumeMesh read_body_mesh(Fields& fields, BodyFile& file) {
  file.path = read_named_file(fields.require("mesh"), "a file of a volume mesh");
  const double unit = read_file_unit(fields);
  file.unit = fields.require("unit").text();
  file.up = read_file_up(fields).value_or("z");
  return read_volume_mesh(file.path, {unit, file.up});
}

WrittenFields written(const BodyFile& file) {
  return {{"mesh", std::filesystem::absolute(file.path).generic_string()},
          {"unit", file.unit},
          {"up", file.up}};
}

std::string vector_text(const Eigen::Vector3d& vector) {
  constexpr int kDigits = 15;
  const Eigen::Vector3d written = vector.array() + 0.0;  // without negative zeros
  return fmt::format("[{}, {}, {}]", format_number(written.x(), kDigits),
                     format_number(written.y(), kDigits), format_number(written.z(), kDigits));
}

}  // namespace pliant
