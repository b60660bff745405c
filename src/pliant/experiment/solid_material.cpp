#include "pliant/experiment/solid_material.h"

#include <algorithm>

#include "pliant/material/material_samples.h"

namespace pliant {

bool is_isochoric(const std::string& component) { return component.ends_with("-bar"); }

bool resists_volume(const Material& material) {
  return std::ranges::any_of(material.components, [](const auto& component) {
    return component.second.stiffness && !is_isochoric(component.first);
  });
}

void require_solid_law(const Material& material, const Location& where) {
  const std::string name = quoted_value(material.name);
  if (material.kind != MaterialKind::solid) {
    throw InputError(where, "needs a solid, and the material " + name + " is cloth",
                     "a material of kind `solid`");
  }
  if (std::ranges::none_of(material.components, [](const auto& component) {
        return component.second.stiffness.has_value();
      })) {
    throw InputError(where, "needs a law, and the material " + name + " has none",
                     "a material with components");
  }
}

void require_same_everywhere(const Material& material, const Location& where) {
  if (!is_heterogeneous(material)) return;
  throw InputError(where,
                   "is of a piece that is the same everywhere, and the material " +
                       quoted_value(material.name) + " differs from place to place",
                   "a material without samples");
}

void require_solid_of_volume(const Material& material, const Location& where) {
  require_solid_law(material, where);
  if (resists_volume(material)) return;
  throw InputError(where,
                   "is of a solid whose volume may change, and nothing in the material " +
                       quoted_value(material.name) + " resists that",
                   "a material with a component `J` or `log-J`");
}

}  // namespace pliant
