#include "pliant/experiment/press/press_setup_fields.h"

#include <array>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/geometry/volume_regions.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

constexpr std::array kSides{"-x", "+x", "-y", "+y", "-z", "+z"};

std::optional<Eigen::Vector3d> axis_named(std::string_view name) {
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (name != kSides[i]) continue;
    return (i % 2 == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i / 2));
  }
  return std::nullopt;
}

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

std::vector<int> read_held(const Value& value, const VolumeMesh& mesh) {
  const std::string name = value.text();
  if (const auto side = axis_named(name)) return nodes_of_side(mesh, *side);
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

Eigen::Vector3d read_direction(const Value& value) {
  if (value.is_scalar()) {
    const auto axis = axis_named(value.text());
    if (!axis) value.fail(quoted_value(value.text()), "-x, +x, -y, +y, -z, +z or [x, y, z]");
    return *axis;
  }
  const Eigen::Vector3d direction = read_vector(value);
  if (direction.norm() == 0) value.fail("has no length", "a direction, e.g. [0, 0, -1]");
  return direction.normalized();
}

void require_movable(const Value& fixed, const PressSetup& setup) {
  if (nodes_to_touch(setup).empty()) {
    fixed.fail("holds the whole surface of the body", "a part of it");
  }
}

}  // namespace

void read_press_setup(Fields& fields, PressSetup& setup, std::string& fixed) {
  const Value held = fields.require("fixed");
  fixed = held.text();
  setup.held = read_held(held, setup.mesh);
  require_movable(held, setup);
  const Value direction = fields.require("direction");
  setup.direction = read_direction(direction);
  const auto radius = fields.optional("radius"), through = fields.optional("through");
  if (radius) setup.radius = radius->positive_quantity(Dimension::length);
  if (through) {
    if (!radius) through->fail("is of a sphere", "`radius` beside it, or a plane without it");
    setup.through = read_vector(*through);
  }
  if (first_touch(setup)) return;
  (through ? *through : direction)
      .fail("leads the sphere past the body", "a line that meets it, through `through`");
}

std::string vector_text(const Eigen::Vector3d& vector) {
  constexpr int kDigits = 15;
  const Eigen::Vector3d written = vector.array() + 0.0;  // without negative zeros
  return fmt::format("[{}, {}, {}]", format_number(written.x(), kDigits),
                     format_number(written.y(), kDigits), format_number(written.z(), kDigits));
}

}  // namespace pliant
