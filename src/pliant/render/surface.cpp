#include "pliant/render/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// Finer than the steps of 8-bit colour.
constexpr int kFieldColours = 512;
// Of the surface's own colour.
constexpr float kEdgeShade = 0.4F, kLineShade = 0.55F;

/// Places of values between the ends of a scale, NaN where there is no value.
Eigen::VectorXf scale_positions(const VertexField& field) {
  const double extent = field.scale.high - field.scale.low;
  Eigen::VectorXf places(field.values.size());
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const double place = extent > 0 ? (field.values[i] - field.scale.low) / extent : 0.5;
    places[i] = std::isnan(field.values[i]) ? std::numeric_limits<float>::quiet_NaN()
                                            : static_cast<float>(place);
  }
  return places;
}

}  // namespace

Surface::Surface(const RenderMesh& mesh, Eigen::Matrix3Xf positions)
    : positions_(std::move(positions)),
      triangles_(mesh.triangles),
      normals_(corner_normals(positions_, triangles_)),
      front_(mesh.front),
      back_(mesh.back),
      edges_(mesh.edges) {
  if (mesh.lines) lines_.emplace(*mesh.lines, positions_, triangles_);
  if (!mesh.field) return;
  PLIANT_ASSERT(mesh.field->values.size() == positions_.cols(), "a field has a value a vertex");
  field_ = scale_positions(*mesh.field);
  const ColourScale& scale = mesh.field->scale;
  no_value_colour_ = scale.colour(std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < kFieldColours; ++i) {
    field_colours_.push_back(map_colour(scale.map, double(i) / (kFieldColours - 1)));
  }
}

Eigen::Vector3f Surface::normal(const RayHit& hit) const {
  const Eigen::Vector3f smooth =
      normals_.normals(Eigen::all, normals_.corners.col(hit.triangle)) * hit.barycentric;
  const float length = smooth.norm();
  if (!(length > 0)) return hit.normal;
  return smooth.dot(hit.normal) < 0 ? Eigen::Vector3f(-smooth / length)
                                    : Eigen::Vector3f(smooth / length);
}

Eigen::Vector3f Surface::rounded_point(const RayHit& hit, const Eigen::Vector3f& point) const {
  Eigen::Vector3f result = point;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3f normal = normals_.normals.col(normals_.corners(k, hit.triangle));
    if (normal.dot(hit.normal) < 0) normal = -normal;
    const Eigen::Vector3f corner = positions_.col(triangles_(k, hit.triangle));
    const float below = std::min(0.0F, normal.dot(point - corner));
    result -= hit.barycentric[k] * below * normal;
  }
  return result;
}

Colour Surface::colour(const RayHit& hit, float half_width) const {
  const Colour plain = plain_colour(hit);
  if (edges_ && on_edge(hit, half_width)) return kEdgeShade * plain;
  if (lines_ && lines_->covers(hit, half_width)) return kLineShade * plain;
  return plain;
}

Colour Surface::plain_colour(const RayHit& hit) const {
  if (field_.size() == 0) return hit.front ? front_ : back_;
  const float place = hit.barycentric.dot(field_(triangles_.col(hit.triangle)));
  if (std::isnan(place)) return no_value_colour_;
  const float index = std::clamp(place, 0.0F, 1.0F) * (kFieldColours - 1);
  return field_colours_[static_cast<size_t>(std::lround(index))];
}

bool Surface::on_edge(const RayHit& hit, float half_width) const {
  const Eigen::Matrix3f corners = positions_(Eigen::all, triangles_.col(hit.triangle));
  const float double_area =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm();
  for (int k = 0; k < 3; ++k) {
    const float opposite_edge = (corners.col((k + 2) % 3) - corners.col((k + 1) % 3)).norm();
    if (hit.barycentric[k] * double_area < half_width * opposite_edge) return true;
  }
  return false;
}

}  // namespace pliant
