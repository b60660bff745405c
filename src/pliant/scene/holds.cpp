#include "pliant/scene/holds.h"

#include <algorithm>
#include <limits>

#include "pliant/base/nearest_name.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"
#include "pliant/scene/keyframe_fields.h"

namespace pliant {
namespace {

/// @param what  "cloth" or "solid"
template <class Piece>
int read_piece_name(const Value& value, const std::string& what, std::span<const Piece> pieces) {
  const std::string name = value.text();
  std::vector<std::string> names;
  for (const Piece& piece : pieces) names.push_back(piece.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    value.fail("there is no " + what + " " + quoted_value(name) + did_you_mean(name, names),
               names.empty() ? "a scene that has one" : list_of_names(names));
  }
  return static_cast<int>(found - names.begin());
}

int read_cloth_name(const Value& value, std::span<const SceneCloth> cloths) {
  return read_piece_name(value, "cloth", cloths);
}

/// The nodes of a solid that a pin holds: it has no named edges and corners.
VertexSelection read_held_nodes(Fields& fields) {
  VertexSelection selection = read_vertex_selection(fields);
  for (const char* key : {"edges", "corners"}) {
    if (auto v = fields.optional(key)) {
      v->fail("are those of cloth", "`vertices`, `nearest`, `groups` or `within`");
    }
  }
  return selection;
}

/// The vertices that a pin or clip holds; only rectangles have edges and corners.
VertexSelection read_held_vertices(Fields& fields, const SceneCloth& cloth) {
  VertexSelection selection = read_vertex_selection(fields);
  if (cloth.mesh.is_rectangle()) return selection;
  for (const char* key : {"edges", "corners"}) {
    if (auto v = fields.optional(key)) {
      v->fail(
          "the mesh of " + quoted_value(cloth.name) + " comes from a file",
          "`vertices`, `nearest`, `groups` or `within`; only grids and rectangles have named edges "
          "and corners");
    }
  }
  return selection;
}

std::array<bool, 3> read_directions(const Value& value) {
  std::array<bool, 3> directions{};
  const std::vector<Value> axes = value.items();
  for (const Value& axis : axes) {
    bool& held = directions[static_cast<std::size_t>(axis.choice({"x", "y", "z"})[0] - 'x')];
    if (held) axis.fail(quoted_value(axis.text()) + " is listed twice", "each axis once");
    held = true;
  }
  if (axes.empty()) value.fail("is empty", "at least one of x, y and z");
  return directions;
}

CordSpring read_spring(Fields& fields) {
  CordSpring spring;
  spring.end = read_keyframed_vector(fields.require("end"));
  spring.length = fields.require("length").positive_quantity(Dimension::length);
  spring.stiffness = fields.require("stiffness").positive_quantity(Dimension::force_per_length);
  return spring;
}

SceneCord read_cord(const Value& value) {
  Fields fields = value.fields();
  SceneCord cord;
  cord.where = value.location();
  const auto at = fields.optional("at"), vertex = fields.optional("vertex");
  if (at.has_value() == vertex.has_value()) {
    value.fail("is not attached at one point", "either `at` or `vertex`");
  }
  if (at) cord.at = read_vector(*at);
  if (vertex) cord.vertex = vertex->integer(0, std::numeric_limits<int>::max());
  if (auto force = fields.optional("force")) {
    cord.force = read_keyframed_vector(*force);
  } else if (fields.optional("end")) {
    cord.spring = read_spring(fields);
  } else {
    value.fail("pulls with nothing", "either `force`, or `end`, `length` and `stiffness`");
  }
  fields.finish();
  return cord;
}

void read_clip_dynamics(Fields& fields, SceneClip& clip) {
  if (auto v = fields.optional("motion")) {
    if (clip.free) v->fail("moves a clip that is free", "either `motion` or `free: true`");
    clip.motion = read_motion(*v);
  }
  if (auto v = fields.optional("cords")) {
    for (const Value& cord : v->items()) clip.cords.push_back(read_cord(cord));
    if (!clip.free && !clip.cords.empty()) {
      v->fail("pull at a clip that cannot follow", "`free: true`");
    }
  }
}

}  // namespace

ScenePin read_scene_pin(const Value& value, std::span<const SceneCloth> cloths,
                        std::span<const SceneSolid> solids) {
  Fields fields = value.fields();
  ScenePin pin;
  pin.where = value.location();
  if (const auto solid = fields.optional("solid")) {
    if (fields.optional("cloth")) value.fail("holds two bodies", "either `cloth` or `solid`");
    pin.piece = static_cast<int>(cloths.size()) + read_piece_name(*solid, "solid", solids);
    pin.vertices = read_held_nodes(fields);
  } else {
    pin.piece = read_cloth_name(fields.require("cloth"), cloths);
    pin.vertices = read_held_vertices(fields, cloths[static_cast<std::size_t>(pin.piece)]);
  }
  if (auto v = fields.optional("directions")) pin.directions = read_directions(*v);
  if (auto v = fields.optional("motion")) pin.motion = read_motion(*v);
  fields.finish();
  return pin;
}

SceneClip read_scene_clip(const Value& value, std::span<const SceneCloth> cloths,
                          std::set<std::string>& taken) {
  Fields fields = value.fields();
  SceneClip clip;
  clip.where = value.location();
  clip.name = read_result_name(fields.require("name"), "a clip", taken);
  clip.cloth = read_cloth_name(fields.require("cloth"), cloths);
  clip.vertices = read_held_vertices(fields, cloths[static_cast<std::size_t>(clip.cloth)]);
  clip.mass = fields.require("mass").positive_quantity(Dimension::mass);
  if (auto v = fields.optional("free")) clip.free = v->flag();
  read_clip_dynamics(fields, clip);
  fields.finish();
  return clip;
}

}  // namespace pliant
