#include "pliant/scene/cloth.h"

#include "pliant/io/named_file.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"
#include "pliant/material/material_file.h"
#include "pliant/scene/rotation_fields.h"

namespace pliant {
namespace {

SceneMaterial read_scene_material(const Value& value) {
  SceneMaterial material;
  material.where = value.location();
  material.file = read_named_file(value, "a material file");
  material.material = read_material(material.file);
  return material;
}

SceneRegion read_region(const Value& value) {
  Fields fields = value.fields();
  SceneRegion region{read_scene_material(fields.require("material")),
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
  inner.finish();
  return shape;
}

Pose read_place(const Value& value) {
  Fields fields = value.fields();
  Pose pose;
  if (auto v = fields.optional("rotate")) pose.rotation = read_rotation(*v).quaternion();
  if (auto v = fields.optional("translate")) pose.translation = read_vector(*v);
  fields.finish();
  return pose;
}

}  // namespace

SceneCloth read_scene_cloth(const Value& value, std::set<std::string>& taken) {
  Fields fields = value.fields();
  SceneCloth cloth;
  cloth.where = value.location();
  cloth.name = read_result_name(fields.require("name"), "a cloth", taken);
  cloth.mesh = read_mesh_source(fields.require("mesh"));
  cloth.material = read_scene_material(fields.require("material"));
  if (auto v = fields.optional("regions")) {
    for (const Value& region : v->items()) cloth.regions.push_back(read_region(region));
  }
  if (auto v = fields.optional("shape")) cloth.shape = read_shape(*v);
  if (auto v = fields.optional("place")) cloth.place = read_place(*v);
  if (auto v = fields.optional("velocity")) cloth.velocity = read_vector(*v);
  fields.finish();
  return cloth;
}

Eigen::Matrix3Xd initial_positions(const SceneCloth& cloth, const Eigen::Matrix3Xd& positions) {
  if (cloth.shape) require_flat(*cloth.shape, positions);
  Eigen::Matrix3Xd initial = cloth.shape ? rolled(*cloth.shape, positions) : positions;
  for (Eigen::Index i = 0; i < initial.cols(); ++i) {
    initial.col(i) = cloth.place.apply(initial.col(i));
  }
  return initial;
}

Eigen::Vector3d initial_position(const SceneCloth& cloth, const Eigen::Vector3d& point) {
  return cloth.place.apply(cloth.shape ? Eigen::Vector3d(rolled(*cloth.shape, point)) : point);
}

}  // namespace pliant
