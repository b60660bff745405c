#include "pliant/capture/match_check.h"

#include <Eigen/LU>

#include "pliant/base/parallel.h"
#include "pliant/capture/median.h"
#include "pliant/capture/scattered.h"

namespace pliant {
namespace {

constexpr int kChains = 100;  // of a camera

Eigen::Matrix2d gradient(const PatchMotion& motion) {
  return Eigen::Matrix2d::Identity() + motion.slope;
}

PatchMotion inverse(const PatchMotion& motion) {
  return {-motion.shift, gradient(motion).inverse() - Eigen::Matrix2d::Identity()};
}

/// Of a patch that had moved by `before`, and has by `after`.
PatchMotion since(const PatchMotion& before, const PatchMotion& after) {
  return {after.shift - before.shift,
          gradient(after) * gradient(before).inverse() - Eigen::Matrix2d::Identity()};
}

/// By how much a patch that is looked for in the first picture misses where it was there.
std::optional<double> back_miss(const TrackedPatch& tracked, const PatchTracker& tracker) {
  const auto patch = ReferencePatch::of(tracker.now(), tracked.now(), tracker.side(tracked) / 2);
  if (!patch) return std::nullopt;
  const auto match = patch->match(tracker.first_spline(), inverse(tracked.motion));
  if (!match) return std::nullopt;
  return (match->motion.shift + tracked.motion.shift).norm();
}

}  // namespace

void MatchMisses::add(const MatchMisses& other) {
  back.insert(back.end(), other.back.begin(), other.back.end());
  drift.insert(drift.end(), other.drift.begin(), other.drift.end());
  chained += other.chained;
  broken += other.broken;
}

MatchQuality MatchMisses::quality() const { return {median(back), median(drift), chained, broken}; }

MatchCheck::MatchCheck(const PatchTracker& tracker) {
  for (const int number : scattered(tracker.count(), kChains)) {
    const TrackedPatch& tracked = tracker.patches()[static_cast<std::size_t>(number)];
    chains_.push_back({number, tracked.patch, tracked.place, {}});
  }
}

MatchMisses MatchCheck::of(const PatchTracker& tracker, int threads) {
  std::vector<std::optional<double>> back(chains_.size());
  with_threads(threads, [&] {
    parallel_for(static_cast<int>(chains_.size()), [&](int i) {
      Chain& chain = chains_[static_cast<std::size_t>(i)];
      follow(chain, tracker);
      const TrackedPatch& tracked = tracker.patches()[static_cast<std::size_t>(chain.number)];
      if (tracked.is_seen) back[static_cast<std::size_t>(i)] = back_miss(tracked, tracker);
    });
  });
  MatchMisses misses;
  misses.chained = static_cast<int>(chains_.size());
  for (const auto& miss : back) {
    if (miss) misses.back.push_back(*miss);
  }
  for (const Chain& chain : chains_) {
    const TrackedPatch& tracked = tracker.patches()[static_cast<std::size_t>(chain.number)];
    misses.broken += !chain.patch;
    if (chain.patch && tracked.is_seen) {
      misses.drift.push_back((chain.place - tracked.now()).norm());
    }
  }
  return misses;
}

void MatchCheck::follow(Chain& chain, const PatchTracker& tracker) {
  if (!chain.patch) return;
  const PatchMotion& after = tracker.patches()[static_cast<std::size_t>(chain.number)].motion;
  const auto match = chain.patch->match(tracker.now(), since(chain.before, after));
  chain.before = after;
  chain.patch.reset();
  if (!match || match->correlation < kAlike) return;
  chain.place += match->motion.shift;
  chain.patch = ReferencePatch::of(tracker.now(), chain.place, tracker.radius());
}

}  // namespace pliant
