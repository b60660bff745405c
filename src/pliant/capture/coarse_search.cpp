#include "pliant/capture/coarse_search.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace pliant {
namespace {

constexpr int kFactor = 4;
constexpr int kReducedRadius = 8;
constexpr double kLeastLikely = 0.5;  // correlation of a motion that is worth a closer look

// The middle of the first pixel of a square is half a square off the square's.
Eigen::Vector2d reduced_place(const Eigen::Vector2d& full) {
  return (full.array() - (kFactor - 1) / 2.0).matrix() / kFactor;
}

/// A motion that a patch may have made, and how alike it is then.
struct LikelyMotion {
  PatchMotion motion;
  double correlation = 0;
};

/// The best of some matches of a patch; nothing where one elsewhere is as good.
std::optional<PatchMatch> sole_match(const std::vector<PatchMatch>& matches) {
  constexpr double kAsGood = 0.05, kElsewhere = 1;  // of correlation; pixels
  const auto best = std::ranges::max_element(matches, {}, &PatchMatch::correlation);
  if (best == matches.end()) return std::nullopt;
  const bool is_sole = std::ranges::none_of(matches, [&](const PatchMatch& other) {
    return other.correlation > best->correlation - kAsGood &&
           (other.motion.shift - best->motion.shift).norm() > kElsewhere;
  });
  return is_sole ? std::optional(*best) : std::nullopt;
}

/// The best of the motions that a patch may have made, and those elsewhere that are nearly as good.
std::vector<LikelyMotion> most_likely(std::vector<LikelyMotion> all) {
  constexpr std::size_t kMost = 4;
  constexpr double kNearly = 0.2, kElsewhere = 3;  // of correlation; pixels
  std::ranges::stable_sort(all, std::greater(), &LikelyMotion::correlation);
  std::vector<LikelyMotion> chosen;
  for (const LikelyMotion& one : all) {
    if (chosen.size() == kMost || one.correlation < all.front().correlation - kNearly) break;
    const bool is_elsewhere = std::ranges::all_of(chosen, [&](const LikelyMotion& other) {
      return (other.motion.shift - one.motion.shift).norm() >= kElsewhere;
    });
    if (is_elsewhere) chosen.push_back(one);
  }
  return chosen;
}

/// Where a patch may have gone by whole pixels, around a shift: all shifts by which it correlates
/// by more than a half.
std::vector<LikelyMotion> likely_shifts(const GreyPicture& rest, const GreyPicture& now,
                                        const Eigen::Vector2i& place,
                                        const Eigen::Vector2i& about) {
  constexpr int kReach = 40, kSide = 2 * kReducedRadius + 1;
  const auto within = [](const GreyPicture& picture, const Eigen::Vector2i& middle) {
    return middle.x() >= kReducedRadius && middle.y() >= kReducedRadius &&
           middle.x() + kReducedRadius < picture.cols() &&
           middle.y() + kReducedRadius < picture.rows();
  };
  const auto patch_at = [](const GreyPicture& picture, const Eigen::Vector2i& middle) {
    GreyPicture patch =
        picture.block(middle.y() - kReducedRadius, middle.x() - kReducedRadius, kSide, kSide);
    patch -= patch.mean();
    return patch;
  };
  std::vector<LikelyMotion> likely;
  if (!within(rest, place)) return likely;
  const GreyPicture patch = patch_at(rest, place);
  const float norm = patch.matrix().norm();
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      const Eigen::Vector2i shift = about + Eigen::Vector2i(x, y);
      if (!within(now, place + shift)) continue;
      const GreyPicture other = patch_at(now, place + shift);
      const float correlation = (patch * other).sum() / (norm * other.matrix().norm());
      if (correlation > kLeastLikely)
        likely.push_back({{.shift = shift.cast<double>()}, correlation});
    }
  }
  return likely;
}

/// What is found from the likeliest of some motions.
/// @return in pixels of the whole pictures
std::optional<PatchMotion> refined(const ReferencePatch& patch, const SplinePicture& now,
                                   std::vector<LikelyMotion> likely) {
  std::vector<PatchMatch> matches;
  for (const LikelyMotion& start : most_likely(std::move(likely))) {
    const auto match = patch.match(now, start.motion);
    if (match && match->correlation >= kAlike) matches.push_back(*match);
  }
  const auto sole = sole_match(matches);
  if (!sole) return std::nullopt;
  return PatchMotion{.shift = kFactor * sole->motion.shift, .slope = sole->motion.slope};
}

}  // namespace

GreyPicture reduced(const GreyPicture& picture, int factor) {
  GreyPicture result(picture.rows() / factor, picture.cols() / factor);
  for (Eigen::Index row = 0; row < result.rows(); ++row) {
    for (Eigen::Index column = 0; column < result.cols(); ++column) {
      result(row, column) = picture.block(row * factor, column * factor, factor, factor).mean();
    }
  }
  return result;
}

CoarseSearch::CoarseSearch(const GreyPicture& first, const GreyPicture& now)
    : first_(reduced(first, kFactor)),
      now_(reduced(now, kFactor)),
      first_spline_(first_),
      now_spline_(now_) {}

std::optional<ReferencePatch> CoarseSearch::patch_at(const Eigen::Vector2d& place) const {
  return ReferencePatch::of(first_spline_, reduced_place(place), kReducedRadius);
}

std::optional<PatchMotion> CoarseSearch::around(const Eigen::Vector2d& place,
                                                const Eigen::Vector2d& shift) const {
  const auto patch = patch_at(place);
  if (!patch) return std::nullopt;
  return refined(*patch, now_spline_,
                 likely_shifts(first_, now_, reduced_place(place).array().round().cast<int>(),
                               (shift / kFactor).array().round().cast<int>()));
}

std::optional<PatchMotion> CoarseSearch::among(const Eigen::Vector2d& place,
                                               const std::vector<PatchMotion>& motions) const {
  const auto patch = patch_at(place);
  if (!patch) return std::nullopt;
  std::vector<LikelyMotion> likely;
  for (PatchMotion motion : motions) {
    motion.shift /= kFactor;
    const auto correlation = patch->correlation(now_spline_, motion);
    if (correlation && *correlation > kLeastLikely) likely.push_back({motion, *correlation});
  }
  return refined(*patch, now_spline_, std::move(likely));
}

}  // namespace pliant
