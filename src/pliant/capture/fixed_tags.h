#pragma once

#include <string>
#include <vector>

#include "pliant/capture/spline_picture.h"
#include "pliant/capture/tag_detector.h"

namespace pliant {

/// Tags that stand still beside the sample, in the pictures of a camera. Where one shows them
/// elsewhere than the first did, the camera was moved in between, or what it shows was.
class FixedTags {
 public:
  /// @param codes  of those that stand still; a camera need not see all of them
  /// @param first  picture, brightness 0 to 1
  /// @param tags   that it shows
  /// @param file   of it
  /// @throws InputError where it shows none of them
  FixedTags(const std::vector<int>& codes, const GreyPicture& first, const TagsByCode& tags,
            const std::string& file);

  /// What speaks against a picture, e.g. "shows the fixed tag 7 1.5 pixels off where ..."; empty:
  /// its tags are where they were.
  /// @param tags  that it shows
  std::string doubt(const TagsByCode& tags) const;

 private:
  std::vector<DetectedTag> first_;
};

}  // namespace pliant
