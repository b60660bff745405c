#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/render/camera.h"
#include "pliant/render/ray_scene.h"
#include "pliant/render/render_scene.h"
#include "pliant/render/sample_table.h"
#include "pliant/render/surface.h"

namespace pliant {

/// One of the rays of a pixel.
struct PixelSample {
  std::uint32_t pixel = 0;    ///< a number that differs from pixel to pixel
  std::uint32_t number = 0;   ///< among the rays of the pixel, from 0
  float pixel_angle = 0;      ///< angle between neighbouring pixels (rad)
  float shadow_strength = 1;  ///< of shadows on the ground: 0 hides them
};

/// The light that reaches a camera along rays into a scene.
///
/// Surfaces are matt (Lambert). The key light comes from a disk in the sky, the ambient light from
/// all around, less of it from below; both are kept off by what is in the way. The ground shows the
/// background, darkened where less light falls on it than on open ground.
class Shading {
 public:
  /// @param scene    must outlive the shading
  /// @param samples  rays that one pixel will ask for
  Shading(const RenderScene& scene, int samples);

  /// Points of the world are given to rays relative to this one, so that single precision does.
  const Eigen::Vector3d& origin() const { return origin_; }

  /// The light along a ray.
  Colour light_along(const Ray& ray, const PixelSample& sample) const;

 private:
  /// A point that light falls on.
  struct LitPoint {
    Eigen::Vector3f start;  // of rays to the light
    Eigen::Vector3f normal;
    PixelSample sample;
  };

  Colour surface_light(const Ray& ray, const RayHit& hit, const PixelSample& sample) const;
  Colour ground_light(const Eigen::Vector3f& point, const PixelSample& sample) const;
  float light_at(const LitPoint& point) const;
  float mix(float key, float ambient) const;
  float key_light(const LitPoint& point) const;
  float ambient_light(const LitPoint& point) const;
  std::optional<float> distance_to_ground(const Ray& ray) const;

  const RenderScene& scene_;
  Eigen::AlignedBox3f box_;  // of all meshes, relative to the origin
  Eigen::Vector3d origin_;
  std::vector<Surface> surfaces_;
  RayScene rays_;
  SampleTable samples_;
  Eigen::Matrix3f light_axes_;  // the last column points to the light
  float light_radius_;          // of its disk at distance 1
  float reach_;                 // how far away something may be that keeps ambient light off
  float nudge_;                 // keeps rays clear of the surface they start from
};

}  // namespace pliant
