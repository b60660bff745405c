#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "pliant/contact/coulomb.h"
#include "pliant/contact/obstacle_shape.h"
#include "pliant/io/fields.h"
#include "pliant/scene/body_source.h"
#include "pliant/scene/motion.h"

namespace pliant {

/// A solid body that keeps cloth out.
struct SceneObstacle {
  std::string name;
  std::variant<ObstacleShape, BodySource> body;
  CoulombFriction friction;           ///< of cloth on it; of a surface one coefficient
  std::optional<Motion> motion = {};  ///< of a body that is led, from where it stands
  Location where;

  /// A convex body; null for another.
  const ObstacleShape* shape() const { return std::get_if<ObstacleShape>(&body); }
  /// A surface of triangles; null for another.
  const BodySource* surface() const { return std::get_if<BodySource>(&body); }
  bool moves() const;
};

/// How cloth touches.
struct SceneContact {
  double thickness = 1e-3;              ///< distance at which surfaces begin to push each other (m)
  std::optional<double> friction = {};  ///< of cloth on cloth; nothing: cloth does not know itself
  Location where = {};
};

bool has_moving_obstacles(std::span<const SceneObstacle> obstacles);

/// Reads an element of the list `obstacles`.
/// @param taken  names of the obstacles so far; gets the new one
/// @throws InputError
SceneObstacle read_scene_obstacle(const Value& value, std::set<std::string>& taken);

/// Reads the section `contact`.
/// @throws InputError
SceneContact read_scene_contact(const Value& value);

}  // namespace pliant
