#include "pliant/imaging/strip_photo.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/imaging/centre_line.h"
#include "pliant/imaging/refused_photo.h"

namespace pliant {
namespace {

// A part of a photograph, turned so that the clamp is on the left.
struct Part {
  Photo photo;
  PixelRegion region;
  bool mirrored = false;

  Eigen::Vector2d from_photo(const Eigen::Vector2d& pixel) const {
    const double x = pixel.x() - region.x;
    return {mirrored ? region.width - 1 - x : x, pixel.y() - region.y};
  }
  Eigen::Vector2d to_photo(const Eigen::Vector2d& pixel) const {
    const double x = mirrored ? region.width - 1 - pixel.x() : pixel.x();
    return {x + region.x, pixel.y() + region.y};
  }
};

PixelRegion whole(const Photo& photo) {
  return {0, 0, static_cast<int>(photo.cols()), static_cast<int>(photo.rows())};
}

// What lies behind the clamp's pixel is left out.
PixelRegion beyond_clamp(PixelRegion region, const StripPhotoOptions& options,
                         const Location& where) {
  if (!options.clamp) return region;
  const int column = static_cast<int>(std::lround(options.clamp->x()));
  const double row = options.clamp->y();
  if (column < region.x || column >= region.x + region.width || row < region.y ||
      row >= region.y + region.height) {
    throw InputError(where, "the clamp's pixel is not within the picture or its region",
                     "the pixel X,Y at which the strip leaves its clamp, from the upper left");
  }
  if (options.clamp_side == ClampSide::right) {
    region.width = column - region.x + 1;
  } else {
    region.width -= column - region.x;
    region.x = column;
  }
  return region;
}

Part part_of(const Photo& photo, const StripPhotoOptions& options, const Location& where) {
  constexpr int kSmallest = 32;  // pixels of a side
  Part part;
  part.region = options.region.value_or(whole(photo));
  require_within(part.region, whole(photo).width, whole(photo).height, where);
  part.region = beyond_clamp(part.region, options, where);
  if (std::min(part.region.width, part.region.height) < kSmallest) {
    throw InputError(where, "too little of the picture is left to find a strip in",
                     fmt::format("at least {0} x {0} pixels", kSmallest));
  }
  part.mirrored = options.clamp_side == ClampSide::right;
  part.photo = photo.block(part.region.y, part.region.x, part.region.height, part.region.width);
  if (part.mirrored) part.photo = part.photo.rowwise().reverse().eval();
  return part;
}

StripTrace trace_of(const StripMask& strip, const CentreLine& line, const Part& part,
                    double scale) {
  StripTrace trace;
  for (const Eigen::Vector2d& point : line.points) {
    const Eigen::Vector2d from_clamp = point - line.points.front();
    trace.pixels.push_back(part.to_photo(point));
    trace.profile.emplace_back(scale * from_clamp.x(), -scale * from_clamp.y());
  }
  trace.length = scale * line.length;
  trace.thickness = scale * strip.thickness;
  trace.scatter = scale * line.scatter;
  trace.clamp_angle = line.clamp_angle;
  trace.tone = strip.tone;
  trace.gaps = strip.gaps;
  return trace;
}

std::string as_seen(const Part& part, StripTone tone, const std::filesystem::path& file) {
  SeenPixels seen = things_seen(part.photo, tone);
  if (part.mirrored) seen = seen.rowwise().reverse().eval();
  return photo_as_seen(file, seen, part.region.x, part.region.y);
}

}  // namespace

StripTrace trace_strip(const std::filesystem::path& file, const StripPhotoOptions& options) {
  PLIANT_ASSERT(options.scale > 0, "pixels have a length");
  const Location where{file.string()};
  const Part part = part_of(read_photo(file), options, where);
  StripSearch search;
  search.tone = options.tone;
  if (options.clamp) search.clamp_row = part.from_photo(*options.clamp).y();
  if (part.mirrored) std::swap(search.clamp_border, search.far_border);
  try {
    const StripMask strip = find_strip(part.photo, search, where);
    return trace_of(strip, centre_line(strip, options.points, where), part, options.scale);
  } catch (const InputError& error) {
    throw RefusedPhoto(error, as_seen(part, options.tone, file));
  }
}

}  // namespace pliant
