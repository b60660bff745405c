#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/patch_tracker.h"

namespace pliant {

/// How matches of a frame held, by some patches of each camera (pixels).
struct MatchQuality {
  /// Median by which a patch that is matched there and back misses where it was.
  double back = 0;
  /// Median distance from a patch to where following it from picture to picture has led.
  double drift = 0;
  int chained = 0;  ///< patches that were followed from picture to picture
  int broken = 0;   ///< of them, lost for good by now
};

/// What some patches of a camera show of its matches in a picture.
struct MatchMisses {
  std::vector<double> back, drift;
  int chained = 0, broken = 0;

  void add(const MatchMisses& other);
  MatchQuality quality() const;
};

/// Tells what matches with the first picture are worth: by matching some patches back, and by
/// following them from picture to picture too, as optical flow does. There errors add up, and what
/// is lost once is lost.
///
/// Both ways minimise the same differences, so that they part where the search goes astray, hardly
/// where cloth has changed or is partly hidden: single squares are left out by how alike they are,
/// and by those around them.
class MatchCheck {
 public:
  /// @param tracker  to which all patches were added
  explicit MatchCheck(const PatchTracker& tracker);

  /// @param tracker  of the constructor; it has followed the next picture
  MatchMisses of(const PatchTracker& tracker, int threads);

 private:
  struct Chain {
    int number;                           // of the tracker's patch
    std::optional<ReferencePatch> patch;  // of the picture before; none: it is broken
    Eigen::Vector2d place;                // there
    PatchMotion before;                   // of the tracker's patch
  };

  static void follow(Chain& chain, const PatchTracker& tracker);

  std::vector<Chain> chains_;
};

}  // namespace pliant
