#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/io/fields.h"
#include "pliant/io/index_list.h"
#include "pliant/material/material.h"
#include "pliant/scene/initial_shape.h"
#include "pliant/scene/mesh_source.h"
#include "pliant/scene/motion.h"

namespace pliant {

/// A material with the file that it was read from.
struct SceneMaterial {
  Material material;
  std::filesystem::path file;
  Location where;  ///< where the scene names it
};

/// Reads a material that a scene names.
/// @throws InputError
SceneMaterial read_scene_material(const Value& value);

/// `{rotate, translate}`.
/// @throws InputError
Pose read_place(const Value& value);

/// Faces of a cloth that are of another material than the rest.
struct SceneRegion {
  SceneMaterial material;
  IndexList faces;
};

/// Where a cloth starts is uncertain by so much: each vertex is moved at random, with a normal
/// distribution along each axis.
struct PositionNoise {
  double amplitude = 0;  ///< standard deviation, m
  int seed = 0;
};

/// A cloth of a scene/1 file.
///
/// Its own coordinates are those of its mesh, in metres; for grids and rectangles (u, v, 0). From
/// there it is shaped, moved by its noise, then placed in the world.
struct SceneCloth {
  std::string name;
  MeshSource mesh;
  SceneMaterial material;
  std::vector<SceneRegion> regions;
  std::optional<RolledShape> shape;
  PositionNoise noise;
  Pose place;
  std::optional<Eigen::Vector3d> velocity;  ///< at the start, m/s; at rest when absent
  Location where;
};

/// Reads an element of the list `cloth`, with its materials; the mesh is not read.
/// @param taken  names of the cloths so far; gets the new one
/// @throws InputError
SceneCloth read_scene_cloth(const Value& value, std::set<std::string>& taken);

/// Where a cloth's vertices are when the simulation starts (m).
/// @param positions  of its mesh, in the cloth's own coordinates
/// @throws InputError where a cloth that is rolled is not flat
Eigen::Matrix3Xd initial_positions(const SceneCloth& cloth, const Eigen::Matrix3Xd& positions);

/// The same for a point of the cloth's own space, without noise.
Eigen::Vector3d initial_position(const SceneCloth& cloth, const Eigen::Vector3d& point);

}  // namespace pliant
