#include "pliant/capture/patch_tracker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/parallel.h"
#include "pliant/capture/coarse_search.h"
#include "pliant/capture/median.h"
#include "pliant/capture/near_places.h"
#include "pliant/capture/scattered.h"
#include "pliant/io/digest.h"

namespace pliant {
namespace {

constexpr int kFewestFound = 5;           // that say where others have gone
constexpr double kNear = 2.3, kWide = 8;  // reach of patches that lead others, in steps
constexpr int kSeeds = 40;                // that are looked for first
constexpr int kSmallestCore = 4;          // radius (pixels)
constexpr double kCoreAlike = 0.9;        // fewer pixels are alike by chance more often

/// Of the middle that is looked for alone.
int core_radius(int radius) { return radius / 2; }

void take(TrackedPatch& point, const PatchMatch& match, bool by_core) {
  point.motion = match.motion;
  point.correlation = match.correlation;
  point.covariance = match.covariance;
  point.is_seen = true;
  point.by_core = by_core;
}

constexpr std::size_t kNumbers = 13;  // of a patch that was looked for

void append(const TrackedPatch& point, std::vector<double>& numbers) {
  const auto add = [&](const auto& values) {
    numbers.insert(numbers.end(), values.data(), values.data() + values.size());
  };
  add(point.motion.shift);
  add(point.motion.slope);
  add(point.covariance);
  numbers.insert(numbers.end(),
                 {point.correlation, point.is_seen ? 1.0 : 0.0, point.by_core ? 1.0 : 0.0});
}

void take(TrackedPatch& point, std::span<const double, kNumbers> numbers) {
  point.motion = {Eigen::Vector2d(numbers.data()), Eigen::Matrix2d(numbers.data() + 2)};
  point.covariance = Eigen::Matrix2d(numbers.data() + 6);
  point.correlation = numbers[10];
  point.is_seen = numbers[11] > 0;
  point.by_core = numbers[12] > 0;
}

/// By how much a patch is elsewhere than those around it tell (pixels).
double miss_of(const TrackedPatch& patch, const LocalMotion& around, double reach) {
  const auto moved = around.at(patch.place, reach);
  return moved ? (moved->position.head<2>() - patch.now()).norm() : INFINITY;
}

}  // namespace

PatchTracker::PatchTracker(GreyPicture first, int radius, double step, const RunContext& context)
    : first_(std::move(first)),
      first_spline_(first_, kMatchSmoothing),
      radius_(radius),
      step_(step),
      context_(context) {}

bool PatchTracker::add(const Eigen::Vector2d& place) {
  auto patch = ReferencePatch::of(first_spline_, place, radius_);
  if (patch) tracked_.push_back({.place = place, .patch = *std::move(patch)});
  return patch.has_value();
}

int PatchTracker::seen() const {
  return static_cast<int>(std::ranges::count_if(tracked_, &TrackedPatch::is_seen));
}

FoundPatches PatchTracker::found() const {
  FoundPatches found{{}, Eigen::Matrix2Xd(2, seen()), Eigen::Matrix2Xd(2, seen())};
  for (int i = 0; i < count(); ++i) {
    const TrackedPatch& patch = tracked_[static_cast<std::size_t>(i)];
    if (!patch.is_seen) continue;
    found.places.col(std::ssize(found.numbers)) = patch.place;
    found.now.col(std::ssize(found.numbers)) = patch.now();
    found.numbers.push_back(i);
  }
  return found;
}

std::string PatchTracker::digest() const {
  std::string places;
  for (const TrackedPatch& point : tracked_) places += as_bytes(point.place);
  return sha256_of(sha256_of(as_bytes(first_)) + sha256_of(places) +
                   fmt::format("{} {}", radius_, step_));
}

void PatchTracker::recall_or(const GreyPicture& picture, const std::string& starts,
                             const std::function<void()>& find) {
  if (digest_.empty()) digest_ = digest();
  const std::string question = fmt::format("where patches {} are in the picture {}{}", digest_,
                                           sha256_of(as_bytes(picture)), starts);
  const std::vector<double> found = context_.journal.answer(question, [&] {
    find();
    std::vector<double> numbers;
    for (const TrackedPatch& point : tracked_) append(point, numbers);
    return numbers;
  });
  for (std::size_t i = 0; i < tracked_.size(); ++i) {
    take(tracked_[i], std::span(found).subspan(kNumbers * i).first<kNumbers>());
  }
}

void PatchTracker::follow(const GreyPicture& grey) {
  now_.emplace(grey, kMatchSmoothing);
  recall_or(grey, "", [&] {
    if (has_jumped(*now_)) {
      const CoarseSearch coarse(first_, grey);
      search(*now_, [&](const TrackedPatch& patch) {
        return coarse.around(patch.place, patch.motion.shift);
      });
    } else {
      match_where_they_were(*now_);
    }
    spread(*now_);
  });
}

void PatchTracker::find_across(const GreyPicture& grey, const MotionCandidates& candidates) {
  std::string starts;
  for (const int number : scattered(count(), kSeeds)) {
    for (const PatchMotion& motion : candidates(tracked_[static_cast<std::size_t>(number)].place)) {
      starts += as_bytes(motion.shift);
      starts += as_bytes(motion.slope);
    }
  }
  recall_or(grey, " from " + sha256_of(starts), [&] {
    const SplinePicture now(grey, kMatchSmoothing);
    const CoarseSearch coarse(first_, grey);
    search(now, [&](const TrackedPatch& patch) {
      return coarse.among(patch.place, candidates(patch.place));
    });
    spread(now);
  });
}

void PatchTracker::look_for(TrackedPatch& point, const SplinePicture& now,
                            PatchMotion start) const {
  const auto match = point.patch.match(now, start);
  if (match && match->correlation > kAlike) {
    take(point, *match, /*by_core=*/false);
  } else {
    point.is_seen = look_for_core(point, now, start, kCoreAlike);
  }
}

bool PatchTracker::look_for_core(TrackedPatch& point, const SplinePicture& now, PatchMotion start,
                                 double least) const {
  const int radius = core_radius(radius_);
  if (radius < kSmallestCore || point.lacks_core) return false;
  if (!point.core) point.core = ReferencePatch::of(first_spline_, point.place, radius);
  point.lacks_core = !point.core;
  if (point.lacks_core) return false;
  const auto match = point.core->match(now, start);
  if (!match || match->correlation < least) return false;
  take(point, *match, /*by_core=*/true);
  return true;
}

int PatchTracker::side(const TrackedPatch& patch) const {
  return 2 * (patch.by_core ? core_radius(radius_) : radius_) + 1;
}

// What is lost little by little is hidden; what is lost at once has jumped.
bool PatchTracker::has_jumped(const SplinePicture& now) {
  if (seen() < kFewestFound) return true;
  int before = 0, after = 0;
  for (const int number : scattered(count(), kSeeds)) {
    TrackedPatch& point = tracked_[static_cast<std::size_t>(number)];
    if (!point.is_seen) continue;
    ++before;
    look_for(point, now, point.motion);
    after += point.is_seen;
  }
  return 2 * after < before;
}

void PatchTracker::match_where_they_were(const SplinePicture& now) {
  with_threads(context_.threads, [&] {
    parallel_for(count(), [&](int i) {
      TrackedPatch& point = tracked_[static_cast<std::size_t>(i)];
      look_for(point, now, point.motion);
    });
  });
}

void PatchTracker::search(const SplinePicture& now, const StartOf& start_of) {
  for (TrackedPatch& point : tracked_) point.is_seen = false;  // what was found may be anything
  const std::vector<int> seeds = scattered(count(), kSeeds);
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(seeds.size()), [&](int seed) {
      const int number = seeds[static_cast<std::size_t>(seed)];
      TrackedPatch& point = tracked_[static_cast<std::size_t>(number)];
      if (const auto start = start_of(point)) look_for(point, now, *start);
    });
  });
}

// From what was found to what is around it.
void PatchTracker::spread(const SplinePicture& now) {
  tried_.assign(tracked_.size(), std::nullopt);
  while (match_beside_found(now, kNear) || match_beside_found(now, kWide) ||
         match_beside_neighbour(now)) {
    context_.stop.throw_if_requested();
  }
  see_bent_by_cores(now);
  leave_out_strays();
}

bool PatchTracker::is_new(int patch, const PatchMotion& start) {
  constexpr double kNearby = 0.5;  // pixels, of the middle and of the rim
  std::optional<PatchMotion>& tried = tried_[static_cast<std::size_t>(patch)];
  if (tried && (tried->shift - start.shift).norm() < kNearby &&
      radius_ * (tried->slope - start.slope).norm() < kNearby) {
    return false;
  }
  tried = start;
  return true;
}

LocalMotion PatchTracker::motion_of_found(double reach) const {
  const FoundPatches patches = found();
  Eigen::Matrix3Xd now = Eigen::Matrix3Xd::Zero(3, patches.now.cols());
  now.topRows<2>() = patches.now;
  return {patches.places, now, reach};
}

// Looks for what is lost where the patches around it say; whether more was found.
bool PatchTracker::match_beside_found(const SplinePicture& now, double steps) {
  const double reach = steps * step_;
  const int before = seen();
  if (before < kFewestFound || before == count()) return false;
  const LocalMotion around = motion_of_found(reach);
  with_threads(context_.threads, [&] {
    parallel_for(count(), [&](int i) {
      TrackedPatch& point = tracked_[static_cast<std::size_t>(i)];
      if (point.is_seen) return;
      const auto moved = around.at(point.place, reach);
      if (!moved) return;
      const PatchMotion start{moved->position.head<2>() - point.place,
                              moved->slope.topRows<2>() - Eigen::Matrix2d::Identity()};
      if (is_new(i, start)) look_for(point, now, start);
    });
  });
  return seen() > before;
}

// Where few were found, far apart, each leads its neighbours by how it is turned and stretched
// itself.
bool PatchTracker::match_beside_neighbour(const SplinePicture& now) {
  const int before = seen();
  if (before == 0 || before == count()) return false;
  const FoundPatches leaders = found();
  const NearPlaces near(leaders.places, kNear * step_);
  with_threads(context_.threads, [&] {
    parallel_for(count(), [&](int i) {
      TrackedPatch& point = tracked_[static_cast<std::size_t>(i)];
      if (point.is_seen) return;
      const auto nearest = near.nearest(point.place);
      if (!nearest) return;
      const int number = leaders.numbers[static_cast<std::size_t>(*nearest)];
      const TrackedPatch& leader = tracked_[static_cast<std::size_t>(number)];
      const PatchMotion& motion = leader.motion;
      const PatchMotion start{motion.shift + motion.slope * (point.place - leader.place),
                              motion.slope};
      if (is_new(i, start)) look_for(point, now, start);
    });
  });
  return seen() > before;
}

double PatchTracker::most_unlike() const {
  constexpr double kTimes = 8, kLeast = 0.02;  // the median; of what two patches do not share
  std::vector<double> unlike;
  for (const TrackedPatch& point : tracked_) {
    if (point.is_seen) unlike.push_back(1 - point.correlation);
  }
  return std::max(kTimes * median(std::move(unlike)), kLeast);
}

// What is bent within a patch is not affine, and makes it unlike.
void PatchTracker::see_bent_by_cores(const SplinePicture& now) {
  if (seen() < kFewestFound) return;
  const double most = most_unlike();
  with_threads(context_.threads, [&] {
    parallel_for(count(), [&](int i) {
      TrackedPatch& point = tracked_[static_cast<std::size_t>(i)];
      if (!point.is_seen || point.by_core || 1 - point.correlation <= most) return;
      look_for_core(point, now, point.motion, point.correlation);
    });
  });
}

void PatchTracker::leave_out_strays() {
  constexpr double kTimes = 8, kLeast = 0.1;  // the median; pixels
  const double reach = kNear * step_;
  if (seen() < kFewestFound) return;
  const LocalMotion around = motion_of_found(reach);
  LocalMotion bent = around;
  bent.bend(Eigen::VectorXd::Zero(seen()));
  std::vector<double> off;  // of the points that were seen
  for (const TrackedPatch& point : tracked_) {
    if (!point.is_seen) continue;
    off.push_back(miss_of(point, around, reach));
    if (off.back() > kLeast) off.back() = std::min(off.back(), miss_of(point, bent, reach));
  }
  const double most_off = std::max(kTimes * median(off), kLeast);
  const double unlike = most_unlike();
  std::size_t next = 0;
  for (TrackedPatch& point : tracked_) {
    if (!point.is_seen) continue;
    point.is_seen = off[next++] <= most_off && 1 - point.correlation <= unlike;
  }
}

}  // namespace pliant
