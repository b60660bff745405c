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
constexpr float kEdgeShade = 0.4F;  // of the surface's own colour

float corner_angle(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

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

Eigen::Matrix3Xf vertex_normals(const Eigen::Matrix3Xf& positions,
                                const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xf normals = Eigen::Matrix3Xf::Zero(3, positions.cols());
  for (const auto& triangle : triangles.colwise()) {
    const Eigen::Matrix3f corners = positions(Eigen::all, triangle);
    const Eigen::Vector3f normal =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).stableNormalized();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3f to_next = corners.col((k + 1) % 3) - corners.col(k);
      const Eigen::Vector3f to_last = corners.col((k + 2) % 3) - corners.col(k);
      normals.col(triangle[k]) += corner_angle(to_next, to_last) * normal;
    }
  }
  for (auto normal : normals.colwise()) normal.stableNormalize();
  return normals;
}

Surface::Surface(const RenderMesh& mesh, Eigen::Matrix3Xf positions)
    : positions_(std::move(positions)),
      triangles_(mesh.triangles),
      normals_(vertex_normals(positions_, triangles_)),
      colour_(mesh.colour),
      edges_(mesh.edges) {
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
      normals_(Eigen::all, triangles_.col(hit.triangle)) * hit.barycentric;
  const float length = smooth.norm();
  if (!(length > 0)) return hit.normal;
  return smooth.dot(hit.normal) < 0 ? Eigen::Vector3f(-smooth / length)
                                    : Eigen::Vector3f(smooth / length);
}

Eigen::Vector3f Surface::rounded_point(const RayHit& hit, const Eigen::Vector3f& point) const {
  Eigen::Vector3f result = point;
  for (int k = 0; k < 3; ++k) {
    const int vertex = triangles_(k, hit.triangle);
    Eigen::Vector3f normal = normals_.col(vertex);
    if (normal.dot(hit.normal) < 0) normal = -normal;
    const float below = std::min(0.0F, normal.dot(point - positions_.col(vertex)));
    result -= hit.barycentric[k] * below * normal;
  }
  return result;
}

Colour Surface::colour(const RayHit& hit, float edge_half_width) const {
  const Colour plain = plain_colour(hit);
  return edges_ && on_edge(hit, edge_half_width) ? Colour(kEdgeShade * plain) : plain;
}

Colour Surface::plain_colour(const RayHit& hit) const {
  if (field_.size() == 0) return colour_;
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
