#include "pliant/render/render.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/parallel.h"
#include "pliant/render/shading.h"

namespace pliant {
namespace {

/// Rays through the points of a picture.
class Lens {
 public:
  Lens(const Camera& camera, const PictureSize& size, const Eigen::Vector3d& origin)
      : axes_(camera_axes(camera).cast<float>()),
        position_((camera.position - origin).cast<float>()),
        centre_(0.5F * static_cast<float>(size.width), 0.5F * static_cast<float>(size.height)),
        pixel_(static_cast<float>(2 * std::tan(camera.field_of_view / 2) / size.height)) {}

  /// @param point  pixels from the left and from the top
  Ray through(const Eigen::Vector2f& point) const {
    const Eigen::Vector2f offset = pixel_ * (point - centre_);
    return {position_, (axes_ * Eigen::Vector3f(offset.x(), -offset.y(), 1)).normalized()};
  }
  /// Angle between neighbouring pixels (rad) in the middle of the picture.
  float pixel_angle() const { return pixel_; }

 private:
  Eigen::Matrix3f axes_;
  Eigen::Vector3f position_;
  Eigen::Vector2f centre_;
  float pixel_;
};

/// Shadows fade towards the edges of a picture: on white paper nothing shows where it ends.
float shadow_strength(const PictureSize& size, const Eigen::Vector2i& at) {
  constexpr float kFadeShare = 0.12F;  // of the shorter side
  const int to_edge = std::min({at.x(), at.y(), size.width - 1 - at.x(), size.height - 1 - at.y()});
  const float fade = kFadeShare * static_cast<float>(std::min(size.width, size.height));
  const float t = std::min(1.0F, static_cast<float>(to_edge) / fade);
  return t * t * (3 - 2 * t);
}

Colour pixel_colour(const Shading& shading, const Lens& lens, const SampleTable& table,
                    PixelSample sample, const Eigen::Vector2i& at, int samples) {
  Colour sum = Colour::Zero();
  for (int s = 0; s < samples; ++s) {
    sample.number = static_cast<std::uint32_t>(s);
    const Ray ray = lens.through(at.cast<float>() + table.point(sample.pixel, sample.number));
    sum += shading.light_along(ray, sample);
  }
  return sum / static_cast<float>(samples);
}

}  // namespace

Image render(const RenderScene& scene, const Camera& camera, const PictureSize& size,
             const RenderQuality& quality, const RunContext& run) {
  PLIANT_ASSERT(quality.samples > 0, "a pixel has samples");
  const Shading shading(scene, quality.samples);
  const Lens lens(camera, size, shading.origin());
  const SampleTable table(quality.samples);
  Image image(size.width, size.height);
  parallel_for(size.height, run.threads, [&](int y) {
    run.stop.throw_if_requested();
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector2i at(x, y);
      const PixelSample sample{
          hash_combine(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), 0,
          lens.pixel_angle(), shadow_strength(size, at)};
      image.at(x, y) = encode_srgb(pixel_colour(shading, lens, table, sample, at, quality.samples));
    }
  });
  return image;
}

}  // namespace pliant
