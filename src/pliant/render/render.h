#pragma once

#include "pliant/base/run_context.h"
#include "pliant/render/camera.h"
#include "pliant/render/image.h"
#include "pliant/render/render_scene.h"

namespace pliant {

/// Size of a picture in pixels.
struct PictureSize {
  int width = 800;
  int height = 600;

  double aspect() const { return double(width) / height; }
};

struct RenderQuality {
  int samples = 16;  ///< rays a pixel; powers of two are spread most evenly
};

/// Draws a scene by ray casting. The same input gives the same bits for any number of threads.
/// @throws Interrupted when `run` was asked to stop
Image render(const RenderScene& scene, const Camera& camera, const PictureSize& size,
             const RenderQuality& quality, const RunContext& run);

}  // namespace pliant
