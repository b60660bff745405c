#include "pliant/capture/frame_doubts.h"

#include <algorithm>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr double kFewest = 0.5;    // of the points, or of a camera's patches
constexpr double kMostBack = 0.2;  // pixels

std::string doubt_of(const SightQuality& quality, const std::vector<std::string>& cameras) {
  if (!quality.moved.empty()) return quality.moved;
  const auto least = std::ranges::min_element(quality.share);
  if (*least < kFewest) {
    return fmt::format("{} finds {:.0f} % of what it saw at rest",
                       cameras[static_cast<std::size_t>(least - quality.share.begin())],
                       100 * *least);
  }
  if (!quality.doubt.empty()) return quality.doubt;
  if (quality.matches.back > kMostBack) {
    return fmt::format(
        "patches that are matched there and back miss where they were by {:.2g} "
        "pixels, as in pictures that are blurred",
        quality.matches.back);
  }
  return {};
}

}  // namespace

std::string contradiction_of(const std::optional<SightQuality>& quality) {
  if (!quality || quality->agreeing >= kFewest) return {};
  return fmt::format(
      "shows points on {:.0f} % of which cameras agree, as if one had been moved, or pictures were "
      "of different moments",
      100 * quality->agreeing);
}

std::vector<FrameDoubt> frame_doubts(const DicSession& made) {
  std::vector<FrameDoubt> doubts;
  for (const int frame : made.used) {
    const auto f = static_cast<std::size_t>(frame);
    std::string why;
    if (frame > 0 && made.qualities[f]) why = doubt_of(*made.qualities[f], made.cameras);
    if (why.empty() && f < made.stands.size() && made.stands[f]) why = made.stands[f]->creep;
    if (!why.empty()) doubts.push_back({frame, std::move(why)});
  }
  return doubts;
}

}  // namespace pliant
