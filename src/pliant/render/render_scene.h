#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/render/colour_map.h"
#include "pliant/render/rest_lines.h"

namespace pliant {

/// One number a vertex, shown by colour.
struct VertexField {
  Eigen::VectorXd values;  ///< NaN where there is none
  ColourScale scale;
};

/// A surface in a picture, seen from both sides.
struct RenderMesh {
  Eigen::Matrix3Xd positions;              ///< m, one column a vertex
  Eigen::Matrix3Xi triangles;              ///< vertices of each triangle
  Colour front = colour_of_rgb(0x7fa3cf);  ///< where the corners of triangles run counter-clockwise
  Colour back = colour_of_rgb(0xb98f66);
  std::optional<VertexField> field = {};  ///< in place of both colours
  std::optional<RestLines> lines = {};
  bool edges = false;  ///< draw the edges of the triangles
};

/// Light from one direction, like the sun's.
struct KeyLight {
  Eigen::Vector3d direction{-0.4, -0.5, 0.8};  ///< towards the light; any length
  double angular_radius = 0.09;                ///< of its disk (rad); 0 makes hard shadows
};

/// What is in a picture. Gravity points along -z.
struct RenderScene {
  std::vector<RenderMesh> meshes;
  std::optional<double> ground;  ///< height (m) of a floor that shows nothing but shadow
  KeyLight light;
  double ambient = 0.42;  ///< part of the light that comes from all around, 0 to 1
  Colour background = Colour::Ones();
};

/// A light over the left shoulder of who looks along `forward`, never below 45 degrees; from below
/// for who looks steeply upwards.
KeyLight light_for_view(const Eigen::Vector3d& forward);

}  // namespace pliant
