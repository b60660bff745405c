#include "pliant/capture/stereo_rest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/capture/median.h"
#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/sight_search.h"
#include "pliant/capture/triangulation.h"

namespace pliant {
namespace {

using Seen = std::vector<std::optional<SeenPlace>>;

/// What interpolation leaves of a match, at least (pixels).
constexpr double kLeastNoise = 0.005;

/// A point by some cameras, and by how far each misses it (pixels).
struct TriedPoint {
  Eigen::Vector3d position;
  Eigen::Matrix3d covariance;
  std::vector<double> misses;
};

// All cameras count alike. Errors of the calibration are larger than those of matches: were places
// weighed by these, a point would move with the weights.
std::optional<TriedPoint> point_of(const std::vector<CameraModel>& cameras, const Seen& seen) {
  std::vector<Sighting> sightings;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    if (seen[c]) sightings.push_back({&cameras[c], seen[c]->pixel, 1});
  }
  const auto point = triangulate(sightings);
  if (!point) return std::nullopt;
  TriedPoint tried{point->point, {}, std::vector<double>(cameras.size(), 0)};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    if (!seen[c]) continue;
    const auto shown = cameras[c].project_with_derivatives(point->point);
    if (!shown) return std::nullopt;
    tried.misses[c] = (shown->pixel - seen[c]->pixel).norm();
    spread += seen[c]->noise * seen[c]->noise * shown->by_point.transpose() * shown->by_point;
  }
  tried.covariance = point->covariance * spread * point->covariance;
  return tried;
}

}  // namespace

double most_miss(double median_miss) {
  constexpr double kTimes = 8, kLeast = 0.3;  // pixels
  return std::max(kTimes * median_miss, kLeast);
}

std::optional<AgreedPoint> agreed_point(const std::vector<CameraModel>& cameras, Seen seen,
                                        double most) {
  while (true) {
    const auto found = point_of(cameras, seen);
    if (!found) return std::nullopt;
    const std::vector<double>& misses = found->misses;
    const auto used = std::ranges::count_if(seen, [](const auto& s) { return s.has_value(); });
    double squares = 0;
    for (const double miss : misses) squares += miss * miss;
    const double miss = std::sqrt(squares / static_cast<double>(2 * used));
    if (miss <= most) {
      AgreedPoint agreed{found->position, found->covariance, miss, {}};
      for (const auto& place : seen) agreed.used.push_back(place.has_value());
      return agreed;
    }
    if (used == 2) return std::nullopt;
    seen[static_cast<std::size_t>(std::ranges::max_element(misses) - misses.begin())].reset();
  }
}

StereoRest match_rest(const std::vector<CameraModel>& cameras,
                      const std::vector<GreyPicture>& pictures, const Quadrilateral& corners,
                      const PatchGrid& grid, const RunContext& context) {
  constexpr double kApart = 4;  // a pixel of the reduced pictures
  StereoRest rest;
  PatchTracker patches(pictures.front(), grid.radius, grid.step, context);
  for (const Eigen::Vector2d& place : places_within(corners, grid.step, grid.radius + 1)) {
    ++rest.places;
    if (!patches.add(place)) ++rest.without_texture;
  }
  std::vector<Seen> seen(patches.patches().size(), Seen(cameras.size()));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i][0] = SeenPlace{patches.patches()[i].place, kLeastNoise};
  }
  rest.shared.push_back(patches.count());
  for (std::size_t c = 1; c < cameras.size(); ++c) {
    patches.find_across(pictures[c], [&](const Eigen::Vector2d& place) {
      return sight_candidates(cameras[0], cameras[c], place, kApart);
    });
    rest.shared.push_back(patches.seen());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const TrackedPatch& patch = patches.patches()[i];
      // What is partly hidden at rest would be looked for together with what hides it.
      if (!patch.is_seen || patch.by_core) continue;
      seen[i][c] = SeenPlace{patch.now(), std::hypot(patch.noise(), kLeastNoise)};
    }
  }
  std::vector<double> misses;
  for (const Seen& own : seen) {
    if (const auto point = agreed_point(cameras, own, INFINITY)) misses.push_back(point->miss);
  }
  rest.median_miss = median(misses);
  for (Seen& own : seen) {
    const auto point = agreed_point(cameras, own, most_miss(rest.median_miss));
    if (!point) continue;
    for (std::size_t c = 0; c < own.size(); ++c) {
      if (!point->used[c]) own[c].reset();
    }
    rest.points.push_back({*point, std::move(own)});
  }
  return rest;
}

}  // namespace pliant
