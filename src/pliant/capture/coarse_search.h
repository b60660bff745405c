#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/reference_patch.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// A picture whose pixels are the means of squares of `factor` x `factor`.
GreyPicture reduced(const GreyPicture& picture, int factor);

/// Looks far around for where patches of a picture have gone in another, in both made smaller. One
/// that may have gone to several places is not found: in a texture that repeats it is not told
/// which is the right one.
class CoarseSearch {
 public:
  CoarseSearch(const GreyPicture& first, const GreyPicture& now);

  /// Some 160 pixels around a shift.
  /// @param place  of the patch in the first picture (pixels)
  /// @return its motion, within some pixels
  std::optional<PatchMotion> around(const Eigen::Vector2d& place,
                                    const Eigen::Vector2d& shift) const;
  /// Near one of some motions.
  std::optional<PatchMotion> among(const Eigen::Vector2d& place,
                                   const std::vector<PatchMotion>& motions) const;

 private:
  std::optional<ReferencePatch> patch_at(const Eigen::Vector2d& place) const;

  GreyPicture first_, now_;
  SplinePicture first_spline_, now_spline_;
};

}  // namespace pliant
