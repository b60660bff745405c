#pragma once

#include <string>
#include <vector>

#include "pliant/capture/patch_tracker.h"

namespace pliant {

/// How surely a camera's patches were found, over all pictures.
///
/// Blur, noise and a coarse or pale texture all make matches uncertain, and one may outweigh the
/// other: what is judged is the error that they leave, not how the pictures look.
class MatchNoise {
 public:
  /// @param tracker  that has followed a picture
  void add(const PatchTracker& tracker);

  /// What speaks against the first picture, with which all were matched; empty: nothing.
  std::string doubt() const;

 private:
  std::vector<double> medians_;  // of each picture: standard deviation of a coordinate (pixels)
};

}  // namespace pliant
