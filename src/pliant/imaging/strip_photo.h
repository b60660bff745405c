#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/imaging/strip_mask.h"

namespace pliant {

enum class ClampSide { left, right };

/// How a photograph of a strip, taken from its side, is to be read.
struct StripPhotoOptions {
  double scale = 0;  ///< length of a pixel in the plane of the strip (m), > 0
  ClampSide clamp_side = ClampSide::left;
  std::optional<Eigen::Vector2d> clamp;  ///< pixel at which the strip leaves its clamp; else the
                                         ///< border of the picture or the region on that side
  std::optional<PixelRegion> region;     ///< to look in; else all of it
  StripTone tone = StripTone::automatic;
  int points = 31;  ///< of the profile, at least 5
};

/// The profile of a strip that hangs from a clamp, read off a photograph.
struct StripTrace {
  std::vector<Eigen::Vector2d> pixels;   ///< of the photograph (y down), the clamp first
  std::vector<Eigen::Vector2d> profile;  ///< m, from the clamp: away from it, and up
  double length = 0;                     ///< m
  double thickness = 0;                  ///< m, as it looks
  double scatter = 0;  ///< m, of the strip's middle about the smooth line that was drawn through it
  double clamp_angle = 0;  ///< rad, by which it leaves the clamp below level
  StripTone tone = StripTone::brighter;
  int gaps = 0;  ///< across which pieces of the strip were joined
};

/// @throws InputError for a file that is no picture, or a region outside it
/// @throws RefusedPhoto for a picture in which no single strip is seen (`find_strip`)
StripTrace trace_strip(const std::filesystem::path& file, const StripPhotoOptions& options);

}  // namespace pliant
