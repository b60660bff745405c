#include "pliant/scene/scene.h"

#include <algorithm>
#include <set>

#include "pliant/io/fields.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

double number_from_zero(const Value& value) {
  const double number = value.number();
  if (number < 0) value.fail("is negative", "a number of at least 0");
  return number;
}

Air read_air(const Value& value) {
  Fields fields = value.fields();
  Air air;
  air.drag = number_from_zero(fields.require("drag"));
  if (auto v = fields.optional("density")) {
    air.density = v->positive_quantity(Dimension::volume_density);
  }
  if (auto v = fields.optional("wind")) air.wind = read_vector(*v);
  fields.finish();
  return air;
}

double read_damping(const Value& value) {
  Fields fields = value.fields();
  const double fraction = number_from_zero(fields.require("fraction"));
  fields.finish();
  return fraction;
}

void read_bodies(Fields& fields, Scene& scene) {
  std::set<std::string> names;
  const auto solids = fields.optional("solids");
  const std::optional<Value> list = solids ? fields.optional("cloth") : fields.require("cloth");
  if (list) {
    for (const Value& node : list->items()) scene.cloth.push_back(read_scene_cloth(node, names));
    if (scene.cloth.empty()) list->fail("has no cloth", "at least one");
  }
  if (!solids) return;
  for (const Value& node : solids->items()) scene.solids.push_back(read_scene_solid(node, names));
  if (scene.solids.empty()) solids->fail("has no solid", "at least one");
}

void read_holds(Fields& fields, Scene& scene) {
  if (auto list = fields.optional("pins")) {
    for (const Value& node : list->items())
      scene.pins.push_back(read_scene_pin(node, scene.cloth, scene.solids));
  }
  std::set<std::string> names;
  if (auto list = fields.optional("clips")) {
    for (const Value& node : list->items()) {
      scene.clips.push_back(read_scene_clip(node, scene.cloth, names));
    }
  }
}

void read_obstacles(Fields& fields, Scene& scene) {
  std::set<std::string> names;
  if (auto list = fields.optional("obstacles")) {
    for (const Value& node : list->items()) {
      scene.obstacles.push_back(read_scene_obstacle(node, names));
    }
  }
  if (auto v = fields.optional("contact")) scene.contact = read_scene_contact(*v);
}

bool has_limits(const Scene& scene) {
  const auto limited = [](const auto& body) { return !body.material.material.limits.empty(); };
  const auto any_limited = [&](const auto& body) {
    return limited(body) || std::ranges::any_of(body.regions, limited);
  };
  return std::ranges::any_of(scene.cloth, any_limited) ||
         std::ranges::any_of(scene.solids, any_limited);
}

/// No step may end beyond a limit of energy.
void require_search_for_limits(const Scene& scene) {
  if (scene.time.solution != StepSolve::linearized || !has_limits(scene)) return;
  throw InputError({scene.file, scene.time.where.line, "time.solve"},
                   "one linear system a step would carry materials beyond their limits of energy",
                   "`iterated` or `converged`");
}

/// What touches is kept apart by a search for less energy, step by step.
void require_search(const Scene& scene) {
  if (scene.obstacles.empty() && !scene.contact.friction) return;
  Location where = scene.contact.where;
  where.field = "contact.friction";
  if (!scene.obstacles.empty()) {
    where = {scene.file, scene.obstacles.front().where.line, "obstacles"};
  }
  if (scene.time.kind == SimulationKind::quasi_static) {
    throw InputError(where, "contact is not there yet in a quasi-static simulation",
                     "`kind: dynamic`");
  }
  if (scene.time.solution == StepSolve::linearized) {
    throw InputError(where, "one linear system a step would carry cloth through what it meets",
                     "`solve: iterated` or `converged`");
  }
}

/// What belongs to movement means nothing along a path of equilibria.
void refuse_movement(Fields& fields, const Scene& scene) {
  const auto refuse_velocity = [](const auto& body) {
    if (!body.velocity) return;
    Location where = body.where;
    where.field += ".velocity";
    throw InputError(where, "means nothing in a quasi-static simulation", "`kind: dynamic`");
  };
  std::ranges::for_each(scene.cloth, refuse_velocity);
  std::ranges::for_each(scene.solids, refuse_velocity);
  if (auto v = fields.optional("damping")) {
    v->fail("means nothing in a quasi-static simulation", "`kind: dynamic`");
  }
}

}  // namespace

Scene scene_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "scene", 1);

  Scene scene;
  scene.file = document.file;
  scene.name = std::filesystem::path(document.file).stem().string();
  if (auto v = fields.optional("name")) scene.name = v->text();
  scene.info = fields.texts("info");
  read_bodies(fields, scene);
  read_holds(fields, scene);
  read_obstacles(fields, scene);
  if (auto v = fields.optional("gravity")) scene.gravity = read_vector(*v);
  if (auto v = fields.optional("air")) scene.air = read_air(*v);
  if (auto v = fields.optional("damping")) scene.damping_fraction = read_damping(*v);
  scene.time = read_stepping(fields.require("time"));
  if (scene.time.kind == SimulationKind::quasi_static) refuse_movement(fields, scene);
  require_search(scene);
  require_search_for_limits(scene);
  scene.output = read_frame_output(fields.optional("output"), scene.time);
  fields.finish();
  return scene;
}

Scene read_scene(const std::filesystem::path& path) { return scene_of(read_yaml(path)); }

}  // namespace pliant
