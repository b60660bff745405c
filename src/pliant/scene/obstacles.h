#pragma once

#include <set>
#include <string>
#include <vector>

#include "pliant/contact/coulomb.h"
#include "pliant/contact/obstacle_shape.h"
#include "pliant/io/fields.h"

namespace pliant {

/// A solid body that stands still and keeps cloth out.
struct SceneObstacle {
  std::string name;
  ObstacleShape shape;
  CoulombFriction friction;  ///< of cloth on it
  Location where;
};

/// How near cloth comes to what it touches.
struct SceneContact {
  double thickness = 1e-3;  ///< distance at which surfaces begin to push each other (m)
};

/// Reads an element of the list `obstacles`.
/// @param taken  names of the obstacles so far; gets the new one
/// @throws InputError
SceneObstacle read_scene_obstacle(const Value& value, std::set<std::string>& taken);

/// Reads the section `contact`.
/// @throws InputError
SceneContact read_scene_contact(const Value& value);

}  // namespace pliant
