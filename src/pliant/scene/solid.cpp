#include "pliant/scene/solid.h"

#include <map>

#include "pliant/base/nearest_name.h"
#include "pliant/geometry/volume_regions.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

SceneMaterial read_solid_material(const Value& value) {
  SceneMaterial material = read_scene_material(value);
  if (material.material.kind != MaterialKind::solid) {
    value.fail("is a material of cloth", "one of the kind `solid`");
  }
  return material;
}

SceneSample read_sample(const Value& value) {
  Fields fields = value.fields();
  SceneSample sample;
  sample.where = value.location();
  sample.at = read_vector(fields.require("at"));
  sample.material = read_solid_material(fields.require("material"));
  fields.finish();
  return sample;
}

/// A material, or samples of it.
void read_material_or_samples(const Value& value, SceneSolid& solid) {
  if (!value.is_mapping()) {
    solid.material = read_solid_material(value);
    return;
  }
  Fields fields = value.fields();
  const Value samples = fields.require("samples");
  for (const Value& item : samples.items()) solid.samples.push_back(read_sample(item));
  if (solid.samples.empty()) samples.fail("is empty", "at least one sample");
  if (auto v = fields.optional("width")) solid.width = v->positive_quantity(Dimension::length);
  fields.finish();
  solid.material = solid.samples.front().material;
}

SolidRegion read_solid_region(const Value& value) {
  Fields fields = value.fields();
  SolidRegion region{read_solid_material(fields.require("material")),
                     fields.require("label").text(), value.location()};
  fields.finish();
  return region;
}

// Names of the regions of a mesh, or their numbers where they have none.
std::map<std::string, int> labels_of(const VolumeMesh& mesh) {
  std::map<std::string, int> labels;
  for (const auto& [label, elements] : elements_of_regions(mesh)) {
    labels[name_of_region(mesh, label)] = label;
  }
  return labels;
}

}  // namespace

SceneSolid read_scene_solid(const Value& value, std::set<std::string>& taken) {
  Fields fields = value.fields();
  SceneSolid solid;
  solid.where = value.location();
  solid.name = read_result_name(fields.require("name"), "a solid", taken);
  solid.mesh = read_volume_source(fields.require("mesh"));
  read_material_or_samples(fields.require("material"), solid);
  if (auto v = fields.optional("regions")) {
    for (const Value& region : v->items()) solid.regions.push_back(read_solid_region(region));
  }
  if (auto v = fields.optional("place")) solid.place = read_place(*v);
  if (auto v = fields.optional("velocity")) solid.velocity = read_vector(*v);
  fields.finish();
  return solid;
}

std::vector<int> material_of_elements(const SceneSolid& solid, const VolumeMesh& mesh) {
  const std::map<std::string, int> labels = labels_of(mesh);
  std::vector<std::string> names;
  for (const auto& [name, label] : labels) names.push_back(name);
  std::map<int, int> materials;  // by label
  for (size_t r = 0; r < solid.regions.size(); ++r) {
    const SolidRegion& region = solid.regions[r];
    const auto found = labels.find(region.label);
    if (found == labels.end()) {
      throw InputError(region.where,
                       "the mesh has no region " + quoted_value(region.label) +
                           did_you_mean(region.label, names),
                       list_of_names(names));
    }
    if (!materials.try_emplace(found->second, 1 + static_cast<int>(r)).second) {
      throw InputError(region.where, "region " + quoted_value(region.label) + " is there twice",
                       "each region once");
    }
  }
  std::vector<int> of_elements;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto found = materials.find(mesh.label_of(e));
    of_elements.push_back(found == materials.end() ? 0 : found->second);
  }
  return of_elements;
}

}  // namespace pliant
