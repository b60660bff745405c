#pragma once

#include <span>

#include <Eigen/Geometry>

#include "pliant/io/obj.h"
#include "pliant/scene/mesh_body.h"
#include "pliant/scene/obstacles.h"

namespace pliant {

/// The surfaces of obstacles for pictures: round bodies in facets, a plane as a square around what
/// is near it. Those that are led stand where they are at a time (s).
/// @param cloth  that a plane's square reaches beyond (m)
ObjMesh obstacle_mesh(std::span<const SceneObstacle> obstacles,
                      const std::vector<BodyPiece>& bodies, const Eigen::AlignedBox3d& cloth,
                      double time);

}  // namespace pliant
