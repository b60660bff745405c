#include "pliant/render/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pliant {
namespace {

/// Ambient rays for each ray from the camera.
constexpr int kAmbientRays = 4;
/// Ambient light from straight below against that from straight above, reflected by the ground.
constexpr float kLightFromBelow = 0.6F;
/// Ambient light that what is in the way reflects itself.
constexpr float kLightFromObstacles = 0.2F;

enum Stream : std::uint32_t { key_stream = 1, ambient_stream = 2 };

Eigen::AlignedBox3d box_of(const std::vector<RenderMesh>& meshes) {
  Eigen::AlignedBox3d box;
  for (const RenderMesh& mesh : meshes) {
    for (const auto& position : mesh.positions.colwise()) box.extend(position.eval());
  }
  return box.isEmpty() ? Eigen::AlignedBox3d(Eigen::Vector3d::Zero().eval()) : box;
}

/// Two unit vectors at right angles to a third and to each other (Duff2017).
Eigen::Matrix3f axes_around(const Eigen::Vector3f& n) {
  const float sign = std::copysign(1.0F, n.z());
  const float a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  Eigen::Matrix3f axes;
  axes.col(0) = Eigen::Vector3f(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  axes.col(1) = Eigen::Vector3f(b, sign + n.y() * n.y() * a, -n.y());
  axes.col(2) = n;
  return axes;
}

/// A point of the unit disk, evenly spread for evenly spread points of the unit square.
Eigen::Vector2f disk_point(const Eigen::Vector2f& square) {
  const float radius = std::sqrt(square.x());
  const float angle = 2 * std::numbers::pi_v<float> * square.y();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A direction around +z with the density of the cosine to it.
Eigen::Vector3f cosine_direction(const Eigen::Vector2f& square) {
  const Eigen::Vector2f disk = disk_point(square);
  return {disk.x(), disk.y(), std::sqrt(std::max(0.0F, 1 - disk.squaredNorm()))};
}

/// Ambient light from a direction, 1 from straight above.
float sky(float upwards) { return 1 + (1 - kLightFromBelow) / 2 * (upwards - 1); }

/// The mean of the sky over the hemisphere about a normal, by the cosine to it: the sky is linear,
/// and the mean direction is two thirds of the normal.
float open_sky(const Eigen::Vector3f& normal) { return sky(2.0F / 3 * normal.z()); }

}  // namespace

Shading::Shading(const RenderScene& scene, int samples)
    : scene_(scene), samples_(samples * kAmbientRays) {
  const Eigen::AlignedBox3d box = box_of(scene.meshes);
  origin_ = box.center();
  box_ = {(box.min() - origin_).cast<float>(), (box.max() - origin_).cast<float>()};
  const float size = std::max(box_.diagonal().norm(), std::numeric_limits<float>::min());
  reach_ = 0.6F * size;
  nudge_ = 2e-5F * size;
  light_axes_ = axes_around(scene.light.direction.normalized().cast<float>());
  light_radius_ = static_cast<float>(std::tan(scene.light.angular_radius));
  surfaces_.reserve(scene.meshes.size());
  for (const RenderMesh& mesh : scene.meshes) {
    surfaces_.emplace_back(mesh, (mesh.positions.colwise() - origin_).cast<float>());
    rays_.add(surfaces_.back().positions(), mesh.triangles);
  }
  rays_.build();
}

Colour Shading::light_along(const Ray& ray, const PixelSample& sample) const {
  const std::optional<RayHit> hit = rays_.first_hit(ray);
  const std::optional<float> ground = distance_to_ground(ray);
  if (hit && !(ground && *ground < hit->distance)) return surface_light(ray, *hit, sample);
  if (ground) return ground_light(ray.origin + *ground * ray.direction, sample);
  return scene_.background;
}

Colour Shading::surface_light(const Ray& ray, const RayHit& hit, const PixelSample& sample) const {
  const Surface& surface = surfaces_[static_cast<size_t>(hit.mesh)];
  const Eigen::Vector3f point = ray.origin + hit.distance * ray.direction;
  const LitPoint lit{surface.rounded_point(hit, point) + nudge_ * hit.normal, surface.normal(hit),
                     sample};
  const float half_pixel = 0.5F * sample.pixel_angle * hit.distance;
  return light_at(lit) * surface.colour(hit, half_pixel);
}

Colour Shading::ground_light(const Eigen::Vector3f& point, const PixelSample& sample) const {
  const LitPoint lit{point, Eigen::Vector3f::UnitZ(), sample};
  const float open = mix(std::max(0.0F, light_axes_(2, 2)), open_sky(lit.normal));
  const float shadow = open > 0 ? 1 - light_at(lit) / open : 0;
  return (1 - sample.shadow_strength * shadow) * scene_.background;
}

float Shading::light_at(const LitPoint& point) const {
  return mix(key_light(point), ambient_light(point));
}

float Shading::mix(float key, float ambient) const {
  const auto share = static_cast<float>(scene_.ambient);
  return (1 - share) * key + share * ambient;
}

float Shading::key_light(const LitPoint& point) const {
  const float cosine = point.normal.dot(light_axes_.col(2));
  if (cosine <= 0) return 0;
  const std::uint32_t seed = hash_combine(point.sample.pixel, key_stream);
  const Eigen::Vector2f disk =
      light_radius_ * disk_point(samples_.point(seed, point.sample.number));
  const Eigen::Vector3f direction =
      (light_axes_ * Eigen::Vector3f(disk.x(), disk.y(), 1)).normalized();
  const bool dark =
      rays_.occluded({point.start, direction}, std::numeric_limits<float>::infinity());
  return dark ? 0 : cosine;
}

float Shading::ambient_light(const LitPoint& point) const {
  // What is kept off is summed, not what arrives: in the open there is no noise.
  float lost = 0;
  if (box_.exteriorDistance(point.start) < reach_) {
    const std::uint32_t seed = hash_combine(point.sample.pixel, ambient_stream);
    const Eigen::Matrix3f axes = axes_around(point.normal);
    for (std::uint32_t k = 0; k < kAmbientRays; ++k) {
      const std::uint32_t index = point.sample.number * kAmbientRays + k;
      const Eigen::Vector3f direction = axes * cosine_direction(samples_.point(seed, index));
      if (rays_.occluded({point.start, direction}, reach_)) lost += sky(direction.z());
    }
  }
  return open_sky(point.normal) - (1 - kLightFromObstacles) / kAmbientRays * lost;
}

std::optional<float> Shading::distance_to_ground(const Ray& ray) const {
  if (!scene_.ground) return std::nullopt;
  const auto height = static_cast<float>(*scene_.ground - origin_.z());
  const float distance = (height - ray.origin.z()) / ray.direction.z();
  // From below the floor cannot be seen.
  if (!(ray.direction.z() < 0 && distance > 0)) return std::nullopt;
  return distance;
}

}  // namespace pliant
