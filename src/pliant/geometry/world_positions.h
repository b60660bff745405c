#pragma once

#include <string>

#include <Eigen/Core>

#include "pliant/geometry/polygon_mesh.h"

namespace pliant {

/// The vertices of a file in the world's unit and axes (m, one column a vertex). The file is
/// turned, not mirrored: with `up` y its -z becomes the world's y (as Blender does), with x its -z
/// becomes x.
/// @param unit  m per unit of the file's coordinates
/// @param up    the axis of the file that becomes the world's z: x, -x, y, -y, z, -z
/// @throws InputError
Eigen::Matrix3Xd world_positions(const PolygonMesh& polygons, double unit, const std::string& up);

/// The same for other points of a file.
/// @param positions  in the file's unit and axes, one column each
Eigen::Matrix3Xd world_positions(const Eigen::Matrix3Xd& positions, double unit,
                                 const std::string& up, const std::string& file);

}  // namespace pliant
