#include "pliant/capture/picture_doubt.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/capture/median.h"
#include "pliant/capture/scattered.h"

namespace pliant {
namespace {

constexpr int kLooks = 200;
constexpr double kMostWhite = 0.1;  // of the pixels; a print's own white is less

/// What a square of a picture looks like.
struct Look {
  double white = 0;  ///< share of its pixels that are as bright as the picture's brightest
  double across = 0, down = 0;  ///< mean squares of differences of neighbours, in variances
};

std::optional<Look> look_at(const GreyPicture& picture, float brightest,
                            const Eigen::Vector2d& middle, int radius) {
  const Eigen::Array2i first = middle.array().round().cast<int>() - radius;
  const int side = 2 * radius + 1;
  if (first.minCoeff() < 0 || first.x() + side > picture.cols() ||
      first.y() + side > picture.rows()) {
    return std::nullopt;
  }
  const GreyPicture square = picture.block(first.y(), first.x(), side, side);
  const float variance = (square - square.mean()).square().mean();
  if (!(variance > 0)) return std::nullopt;
  const int less = side - 1;
  const float across = (square.rightCols(less) - square.leftCols(less)).square().mean();
  const float down = (square.bottomRows(less) - square.topRows(less)).square().mean();
  return Look{(square == brightest).cast<double>().mean(), across / variance, down / variance};
}

}  // namespace

std::string first_picture_doubt(const PatchTracker& tracker) {
  const float brightest = tracker.first().maxCoeff();
  std::vector<double> white;
  for (const int number : scattered(tracker.count(), kLooks)) {
    const TrackedPatch& patch = tracker.patches()[static_cast<std::size_t>(number)];
    const auto look = look_at(tracker.first(), brightest, patch.place, tracker.radius());
    if (look) white.push_back(look->white);
  }
  const double share = median(std::move(white));
  if (share <= kMostWhite) return {};
  return fmt::format(
      "is over-exposed: {:.0f} % of its pixels on the sample are as bright as its brightest, and "
      "what is beyond that is not seen to move",
      100 * share);
}

std::vector<std::string> first_picture_warnings(const PatchTracker& tracker,
                                                const MatchNoise& noise, const std::string& file) {
  std::vector<std::string> warnings;
  for (const std::string& doubt : {first_picture_doubt(tracker), noise.doubt()}) {
    if (!doubt.empty()) warnings.push_back(fmt::format("{} {}", file, doubt));
  }
  return warnings;
}

std::string picture_doubt(const PatchTracker& tracker, const GreyPicture& now) {
  constexpr double kLeastSteep = 0.65;  // of the first picture
  const float brightest_first = tracker.first().maxCoeff(), brightest = now.maxCoeff();
  std::vector<double> across, down, white;
  for (const int number : scattered(tracker.count(), kLooks)) {
    const TrackedPatch& patch = tracker.patches()[static_cast<std::size_t>(number)];
    if (!patch.is_seen) continue;
    const auto before = look_at(tracker.first(), brightest_first, patch.place, tracker.radius());
    const auto after = look_at(now, brightest, patch.now(), tracker.radius());
    if (!before || !after) continue;
    white.push_back(after->white - before->white);
    across.push_back(after->across / before->across);
    down.push_back(after->down / before->down);
  }
  if (white.empty()) return {};
  if (const double share = median(white); share > kMostWhite) {
    return fmt::format("is over-exposed: {:.0f} % more of its pixels than at rest are white",
                       100 * share);
  }
  if (std::min(median(across), median(down)) < kLeastSteep) {
    return "is blurred: brightness changes from pixel to pixel by less than at rest";
  }
  return {};
}

}  // namespace pliant
