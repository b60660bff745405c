#include "pliant/scene/obstacles.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"
#include "pliant/scene/keyframe_fields.h"

namespace pliant {
namespace {

HalfSpace read_plane(const Value& value) {
  Fields fields = value.fields();
  HalfSpace plane;
  plane.point = read_vector(fields.require("point"));
  const Value normal = fields.require("normal");
  plane.normal = read_vector(normal);
  if (plane.normal.isZero()) normal.fail("has no direction", "a vector out of the body");
  plane.normal.normalize();
  fields.finish();
  return plane;
}

Sphere read_sphere(const Value& value) {
  Fields fields = value.fields();
  Sphere sphere;
  sphere.centre = read_vector(fields.require("centre"));
  sphere.radius = fields.require("radius").positive_quantity(Dimension::length);
  fields.finish();
  return sphere;
}

Capsule read_capsule(const Value& value) {
  Fields fields = value.fields();
  Capsule capsule;
  capsule.from = read_vector(fields.require("from"));
  capsule.to = read_vector(fields.require("to"));
  if (capsule.from == capsule.to) value.fail("begins where it ends", "a sphere, or two points");
  capsule.radius = fields.require("radius").positive_quantity(Dimension::length);
  fields.finish();
  return capsule;
}

Box read_box(const Value& value) {
  Fields fields = value.fields();
  Box box;
  box.centre = read_vector(fields.require("centre"));
  const Value size = fields.require("size");
  box.half = read_vector(size) / 2;
  if (!(box.half.minCoeff() > 0)) size.fail("has no extent", "three lengths above 0, in m");
  fields.finish();
  return box;
}

using Body = std::variant<ObstacleShape, BodySource>;

Body read_body(Fields& fields, const Value& value) {
  using Read = Body (*)(const Value&);
  constexpr std::pair<std::string_view, Read> kKinds[] = {
      {"plane", [](const Value& v) -> Body { return read_plane(v); }},
      {"sphere", [](const Value& v) -> Body { return read_sphere(v); }},
      {"capsule", [](const Value& v) -> Body { return read_capsule(v); }},
      {"box", [](const Value& v) -> Body { return read_box(v); }},
      {"mesh", [](const Value& v) -> Body { return read_body_mesh(v); }},
      {"sequence", [](const Value& v) -> Body { return read_body_sequence(v); }}};
  std::vector<std::pair<Value, Read>> given;
  for (const auto& [key, read] : kKinds) {
    if (auto v = fields.optional(key)) given.emplace_back(*v, read);
  }
  if (given.size() != 1) {
    value.fail(given.empty() ? "has no shape" : "has several shapes",
               "one of `plane`, `sphere`, `capsule`, `box`, `mesh` and `sequence`");
  }
  const auto& [shape, read] = given.front();
  return read(shape);
}

double read_coefficient(const Value& value) {
  const double coefficient = value.number();
  constexpr double kLargest = 10;
  if (coefficient < 0) value.fail("is negative", "a coefficient of friction of at least 0");
  if (coefficient > kLargest) {
    value.fail("is more than any fabric has", fmt::format("at most {}", kLargest));
  }
  return coefficient;
}

CoulombFriction read_friction(const Value& value) {
  if (value.is_scalar()) {
    const double both = read_coefficient(value);
    return {both, both};
  }
  Fields fields = value.fields();
  CoulombFriction friction;
  friction.sticking = read_coefficient(fields.require("static"));
  const Value kinetic = fields.require("kinetic");
  friction.sliding = read_coefficient(kinetic);
  if (friction.sliding > friction.sticking) {
    kinetic.fail("exceeds the static coefficient", fmt::format("at most {}", friction.sticking));
  }
  fields.finish();
  return friction;
}

Motion read_obstacle_motion(const Value& value) {
  Motion motion = read_motion(value);
  const Pose first = pose_at(motion, 0);
  if (!first.translation.isZero(1e-9) || !first.rotation.isApprox(Pose{}.rotation, 1e-9)) {
    value.fail("begins elsewhere than the obstacle stands",
               "no translation and no rotation at the time 0");
  }
  return motion;
}

}  // namespace

SceneObstacle read_scene_obstacle(const Value& value, std::set<std::string>& taken) {
  Fields fields = value.fields();
  SceneObstacle obstacle;
  obstacle.where = value.location();
  obstacle.name = read_result_name(fields.require("name"), "an obstacle", taken);
  obstacle.body = read_body(fields, value);
  const bool is_sequence = obstacle.surface() && obstacle.surface()->rate > 0;
  if (auto v = fields.optional("friction")) {
    obstacle.friction = read_friction(*v);
    if (obstacle.surface() && obstacle.friction.sticking != obstacle.friction.sliding) {
      v->fail("has two coefficients", "one coefficient, of a body that is a mesh");
    }
  }
  if (auto v = fields.optional("motion")) {
    if (is_sequence) v->fail("moves what its frames move", "a sequence without `motion`");
    obstacle.motion = read_obstacle_motion(*v);
  }
  fields.finish();
  return obstacle;
}

bool SceneObstacle::moves() const {
  return motion.has_value() || (surface() && surface()->files.size() > 1);
}

bool has_moving_obstacles(std::span<const SceneObstacle> obstacles) {
  return std::ranges::any_of(obstacles, &SceneObstacle::moves);
}

SceneContact read_scene_contact(const Value& value) {
  Fields fields = value.fields();
  SceneContact contact;
  contact.where = value.location();
  if (auto v = fields.optional("thickness")) {
    constexpr double kLeast = 1e-5, kMost = 0.1;
    contact.thickness = v->positive_quantity(Dimension::length);
    if (contact.thickness < kLeast || contact.thickness > kMost) {
      v->fail("is no thickness of a contact", "10 um to 10 cm");
    }
  }
  if (auto v = fields.optional("friction")) contact.friction = read_coefficient(*v);
  fields.finish();
  return contact;
}

}  // namespace pliant
