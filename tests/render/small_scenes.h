#pragma once

#include <cmath>

#include "pliant/render/render.h"

namespace pliant::test {

/// A rectangle from `corner` along two sides, in two triangles.
inline RenderMesh rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& side,
                            const Eigen::Vector3d& other_side) {
  RenderMesh mesh;
  mesh.positions.resize(3, 4);
  mesh.positions << corner, corner + side, corner + side + other_side, corner + other_side;
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

/// A camera at distance 2 from the origin looking along +y at a field of 2 x 2 m there.
inline Camera front_camera() {
  Camera camera{{0, -2, 0}, {0, 0, 0}};
  camera.field_of_view = 2 * std::atan(0.5);
  return camera;
}

/// A camera at height 2 looking down at a field of 2 x 2 m of the plane z = 0, y upwards.
inline Camera top_camera() {
  Camera camera{{0, 0, 2}, {0, 0, 0}};
  camera.up = Eigen::Vector3d::UnitY();
  camera.field_of_view = 2 * std::atan(0.5);
  return camera;
}

inline bool is_background(const Pixel& pixel) { return pixel == Pixel{255, 255, 255}; }

inline int brightness(const Pixel& pixel) { return pixel[0] + pixel[1] + pixel[2]; }

}  // namespace pliant::test
