#include "pliant/material/fill.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant {
namespace {

bool knows_any(const Material& material, bool bending) {
  const std::vector<std::string>& names = cloth_component_names();
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return is_bending(name) == bending && !is_contraction(name) && is_known(material, name);
  });
}

/// The membrane's strain measure becomes the filler's where the material has no membrane component
/// of its own.
void match_membrane(Material& material, const Material& filler, const Location& where) {
  if (!knows_any(material, false)) material.membrane = filler.membrane;
  if (material.membrane == filler.membrane) return;
  throw InputError(
      where,
      fmt::format("the membrane strain of {} is `{}`", quoted_value(filler.name),
                  name_of(filler.membrane)),
      fmt::format("`{}`, as of {}", name_of(material.membrane), quoted_value(material.name)));
}

std::string bending_text(const Material& material) {
  return material.bending_mesh.empty()
             ? fmt::format("`{}` of a {}", material.bending, material.bending_of)
             : fmt::format("`{}` of the {} of {}", material.bending, material.bending_of,
                           quoted_value(material.bending_mesh));
}

/// The same for what bending stiffness belongs to.
void match_bending(Material& material, const Material& filler, const Location& where) {
  if (!knows_any(material, true)) {
    material.bending = filler.bending;
    material.bending_of = filler.bending_of;
    material.bending_mesh = filler.bending_mesh;
  }
  if (material.bending == filler.bending && material.bending_of == filler.bending_of &&
      material.bending_mesh == filler.bending_mesh) {
    return;
  }
  throw InputError(
      where,
      fmt::format("the bending of {} is {}", quoted_value(filler.name), bending_text(filler)),
      fmt::format("{}, as of {}", bending_text(material), quoted_value(material.name)));
}

}  // namespace

bool is_known(const Material& material, const std::string& component) {
  const auto found = material.components.find(component);
  return found != material.components.end() && found->second.stiffness &&
         found->second.status != ComponentStatus::unmeasured;
}

const std::vector<std::string>& sheet_component_names() {
  static const std::vector<std::string> names{"stretch.weft", "stretch.warp", "shear",
                                              "bend.weft",    "bend.warp",    "bend.diagonal"};
  return names;
}

std::vector<std::string> components_of_sheet(const Material& material) {
  std::vector<std::string> names = sheet_component_names();
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    if (solid_metric_of(name) && is_known(material, name)) names.push_back(name);
  }
  return names;
}

std::vector<std::string> fillable_components(const Material& material, const Material& filler) {
  std::vector<std::string> names;
  for (const std::string& name : cloth_component_names()) {
    if (solid_metric_of(name) || is_contraction(name)) continue;
    if (!is_known(material, name) && is_known(filler, name)) names.push_back(name);
  }
  return names;
}

Material filled(const Material& material, const Material& filler, const Location& where) {
  const std::vector<std::string> names = fillable_components(material, filler);
  if (names.empty()) return material;
  Material result = material;
  const auto bends = std::count_if(names.begin(), names.end(),
                                   [](const std::string& name) { return is_bending(name); });
  if (bends > 0) match_bending(result, filler, where);
  if (bends < static_cast<long>(names.size())) match_membrane(result, filler, where);
  for (const std::string& name : names) {
    MaterialComponent component = filler.components.at(name);
    component.status = ComponentStatus::assumed;
    result.components[name] = std::move(component);
  }
  result.provenance["filled"] = fmt::format("{} from {}", fmt::join(names, ", "), filler.name);
  return result;
}

void require_complete(const Material& material, std::span<const std::string> names,
                      const Location& where) {
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    if (!is_known(material, name)) missing.push_back(name);
  }
  if (missing.empty()) return;
  const bool bias =
      is_known(material, "stretch.bias") && std::ranges::find(missing, "shear") != missing.end();
  throw InputError(
      where,
      fmt::format("{} of the material {} {} not measured", fmt::join(missing, ", "),
                  quoted_value(material.name), missing.size() == 1 ? "was" : "were"),
      std::string("a measurement, or --fill FILE with a material to take it from") +
          (bias ? "; bias strips tell shear in a fit with model: {strips: sheet}" : ""));
}

}  // namespace pliant
