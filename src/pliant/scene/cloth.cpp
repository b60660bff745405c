#include "pliant/scene/cloth.h"

#include <cstdint>
#include <limits>

#include "pliant/base/random.h"
#include "pliant/io/named_file.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"
#include "pliant/material/material_file.h"
#include "pliant/scene/rotation_fields.h"

namespace pliant {
namespace {

SceneMaterial read_cloth_material(const Value& value) {
  SceneMaterial material = read_scene_material(value);
  if (material.material.kind != MaterialKind::cloth) {
    value.fail("is a material of solids", "one of the kind `cloth`");
  }
  return material;
}

SceneRegion read_region(const Value& value) {
  Fields fields = value.fields();
  SceneRegion region{read_cloth_material(fields.require("material")),
                     read_index_list(fields.require("faces"))};
  fields.finish();
  return region;
}

RolledShape read_shape(const Value& value) {
  Fields fields = value.fields();
  const Value cylinder = fields.require("cylinder");
  fields.finish();
  Fields inner = cylinder.fields();
  RolledShape shape;
  shape.where = cylinder.location();
  shape.radius = inner.require("radius").positive_quantity(Dimension::length);
  const std::string axis = inner.require("axis").choice({"u", "v", "diagonal"});
  shape.axis = axis == "u"   ? CylinderAxis::u
               : axis == "v" ? CylinderAxis::v
                             : CylinderAxis::diagonal;
  if (auto v = inner.optional("side")) {
    shape.towards_back = v->choice({"front", "back"}) == "back";
  }
  if (auto v = inner.optional("pitch")) shape.pitch = v->positive_quantity(Dimension::length);
  inner.finish();
  return shape;
}

PositionNoise read_noise(const Value& value) {
  Fields fields = value.fields();
  PositionNoise noise;
  noise.amplitude = fields.require("amplitude").positive_quantity(Dimension::length);
  if (auto v = fields.optional("seed")) {
    noise.seed = v->integer(0, std::numeric_limits<int>::max());
  }
  fields.finish();
  return noise;
}

Eigen::Matrix3Xd moved_at_random(const PositionNoise& noise, const Eigen::Matrix3Xd& positions) {
  RandomStream random(static_cast<std::uint64_t>(noise.seed));
  Eigen::Matrix3Xd moved = positions;
  for (double& coordinate : moved.reshaped()) coordinate += noise.amplitude * random.normal();
  return moved;
}

}  // namespace

SceneMaterial read_scene_material(const Value& value) {
  SceneMaterial material;
  material.where = value.location();
  material.file = read_named_file(value, "a material file");
  material.material = read_material(material.file);
  return material;
}

Pose read_place(const Value& value) {
  Fields fields = value.fields();
  Pose pose;
  if (auto v = fields.optional("rotate")) pose.rotation = read_rotation(*v).quaternion();
  if (auto v = fields.optional("translate")) pose.translation = read_vector(*v);
  fields.finish();
  return pose;
}

SceneCloth read_scene_cloth(const Value& value, std::set<std::string>& taken) {
  Fields fields = value.fields();
  SceneCloth cloth;
  cloth.where = value.location();
  cloth.name = read_result_name(fields.require("name"), "a cloth", taken);
  cloth.mesh = read_mesh_source(fields.require("mesh"));
  cloth.material = read_cloth_material(fields.require("material"));
  if (auto v = fields.optional("regions")) {
    for (const Value& region : v->items()) cloth.regions.push_back(read_region(region));
  }
  if (auto v = fields.optional("shape")) cloth.shape = read_shape(*v);
  if (auto v = fields.optional("noise")) cloth.noise = read_noise(*v);
  if (auto v = fields.optional("place")) cloth.place = read_place(*v);
  if (auto v = fields.optional("velocity")) cloth.velocity = read_vector(*v);
  fields.finish();
  return cloth;
}

Eigen::Matrix3Xd initial_positions(const SceneCloth& cloth, const Eigen::Matrix3Xd& positions) {
  if (cloth.shape) require_rollable(*cloth.shape, positions);
  Eigen::Matrix3Xd initial = cloth.shape ? rolled(*cloth.shape, positions) : positions;
  if (cloth.noise.amplitude > 0) initial = moved_at_random(cloth.noise, initial);
  for (Eigen::Index i = 0; i < initial.cols(); ++i) {
    initial.col(i) = cloth.place.apply(initial.col(i));
  }
  return initial;
}

Eigen::Vector3d initial_position(const SceneCloth& cloth, const Eigen::Vector3d& point) {
  return cloth.place.apply(cloth.shape ? Eigen::Vector3d(rolled(*cloth.shape, point)) : point);
}

}  // namespace pliant
