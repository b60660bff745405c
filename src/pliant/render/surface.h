#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/render/corner_normals.h"
#include "pliant/render/ray_scene.h"
#include "pliant/render/render_scene.h"
#include "pliant/render/rest_lines.h"

namespace pliant {

/// A mesh made ready for shading: what is at a point where a ray meets it.
class Surface {
 public:
  /// @param positions  of the mesh, in the coordinates of the rays
  Surface(const RenderMesh& mesh, Eigen::Matrix3Xf positions);

  const Eigen::Matrix3Xf& positions() const { return positions_; }

  /// The smooth normal, on the side of the flat one.
  Eigen::Vector3f normal(const RayHit& hit) const;

  /// The point that a curved surface through the triangle's corners would have there: where the
  /// flat triangle would shade itself at the rim of the lit side, rays start from it instead
  /// (Hanika2021).
  Eigen::Vector3f rounded_point(const RayHit& hit, const Eigen::Vector3f& point) const;

  /// The reflectance, lines and edges included.
  /// @param half_width  half the width of a drawn edge, and of the thinnest line (m)
  Colour colour(const RayHit& hit, float half_width) const;

 private:
  Colour plain_colour(const RayHit& hit) const;
  bool on_edge(const RayHit& hit, float half_width) const;

  Eigen::Matrix3Xf positions_;
  Eigen::Matrix3Xi triangles_;
  CornerNormals normals_;
  Colour front_;
  Colour back_;
  std::optional<RestLinePattern> lines_;
  bool edges_;
  Eigen::VectorXf field_;              // per vertex: 0 = first colour, 1 = last; or empty
  std::vector<Colour> field_colours_;  // of the scale, evenly spaced
  Colour no_value_colour_;
};

}  // namespace pliant
