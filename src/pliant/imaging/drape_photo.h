#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/drape/silhouette.h"
#include "pliant/imaging/photo.h"

namespace pliant {

/// How a photograph of a draped specimen, taken from above, is to be read.
struct DrapePhotoOptions {
  double scale = 0;    ///< length of a pixel at the specimen's height (m), > 0
  double disc = 0.18;  ///< diameter of the disc that carries it (m), > 0
  /// Pixel of the disc's middle; else that of the largest circle within the silhouette.
  std::optional<Eigen::Vector2d> middle = {};
  std::optional<PixelRegion> region = {};  ///< to look in; else all of it
};

/// A silhouette, read off a photograph.
struct DrapeTrace {
  Silhouette silhouette;                 ///< the picture's right is x, its top is y
  std::vector<Eigen::Vector2d> outline;  ///< pixels of the photograph (y down), closed
  Eigen::Vector2d middle;                ///< pixel of the disc's middle
};

/// @throws InputError for a file that is no picture, a region that is not within it, or a
/// silhouette
///         that does not cover the disc or its middle
/// @throws RefusedPhoto for a picture in which no specimen is seen (`find_drape`)
DrapeTrace trace_drape(const std::filesystem::path& file, const DrapePhotoOptions& options);

}  // namespace pliant
