#include "pliant/scene/cloth_regions.h"

#include <fmt/format.h>

#include "pliant/base/add_once.h"
#include "pliant/geometry/grid_pattern.h"
#include "pliant/material/fill.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/material/use_warnings.h"
#include "pliant/mechanics/cloth_potentials.h"

namespace pliant {
namespace {

// Cloths and regions may share a material, and its warnings.
Material usable(const SceneMaterial& given, const std::optional<Material>& filler,
                std::vector<std::string>& warnings) {
  Material material = given.material;
  for (const std::string& warning : use_warnings(material, components_of_sheet(material))) {
    add_once(warning, warnings);
  }
  if (filler) {
    for (const std::string& component : fillable_components(material, *filler)) {
      add_once(component + " of " + quoted_value(material.name) + " was not measured: that of " +
                   quoted_value(filler->name) + " is assumed",
               warnings);
    }
    material = filled(material, *filler, given.where);
  }
  require_complete(material, sheet_component_names(), given.where);
  require_positive_stiffness(material, sheet_component_names(), given.where);
  return held_beyond_range(material);
}

void require_mass(const ClothRegion& region, const Scene& scene) {
  const bool needed = scene.time.kind == SimulationKind::dynamic || !scene.gravity.isZero();
  if (region.material.density > 0 || !needed) return;
  throw InputError(region.where,
                   "the material " + quoted_value(region.material.name) + " has no density",
                   "a material with \"density\" above zero (kg/m^2), for cloth that has mass");
}

void require_own_limits(const ClothRegion& region) {
  if (region.material.membrane != MembraneMeasure::spring) return;
  for (const EnergyLimit& limit : region.material.limits) {
    if (limit.of.size() == 1 && limit.of.front() != kCoupling) continue;
    throw InputError(region.where,
                     fmt::format("{} of {} limits the energies of several springs together",
                                 limit_name(limit.of), quoted_value(region.material.name)),
                     "a limit for each, or the membrane `stvk`");
  }
}

void require_grid(const ClothRegion& region, const TriangleMesh& mesh) {
  if (!needs_grid(region.material) || is_cut_from_rectangles(mesh)) return;
  throw InputError(region.where,
                   "the springs of " + quoted_value(region.material.name) +
                       " need a grid of rectangles along weft and warp, which this mesh is not",
                   "a mesh of the kind \"grid\", or a material with other measures");
}

}  // namespace

std::vector<ClothRegion> cloth_regions(const SceneCloth& cloth, const ClothMesh& mesh,
                                       const Scene& scene, const std::optional<Material>& filler,
                                       std::vector<std::string>& warnings) {
  std::vector<ClothRegion> regions{
      {usable(cloth.material, filler, warnings), cloth.material.where, {}}};
  for (const SceneRegion& region : cloth.regions) {
    regions.push_back({usable(region.material, filler, warnings), region.material.where, {}});
  }
  const std::vector<int> region_of = material_of_triangles(cloth, mesh);
  for (int t = 0; t < mesh.mesh.triangle_count(); ++t) {
    regions[static_cast<size_t>(region_of[static_cast<size_t>(t)])].triangles.push_back(t);
  }
  std::erase_if(regions, [](const ClothRegion& region) { return region.triangles.empty(); });
  for (const ClothRegion& region : regions) {
    require_mass(region, scene);
    require_own_limits(region);
    require_grid(region, mesh.mesh);
  }
  return regions;
}

}  // namespace pliant
