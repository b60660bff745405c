#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/reference_patch.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// A picture whose pixels are the means of squares of `factor` x `factor`.
GreyPicture reduced(const GreyPicture& picture, int factor);

/// Looks for where patches of one picture have gone in another, far around, in pictures of a
/// quarter of their size. A patch that has gone to several places that are equally like it is not
/// found: in a texture that repeats it is not told which is the right one.
class CoarseSearch {
 public:
  CoarseSearch(const GreyPicture& first, const GreyPicture& now);

  /// Some 160 pixels around a shift.
  /// @param place  of the patch in the first picture (pixels)
  /// @return its motion within some pixels
  std::optional<PatchMotion> around(const Eigen::Vector2d& place,
                                    const Eigen::Vector2d& shift) const;
  /// By some motions that it may have made.
  std::optional<PatchMotion> among(const Eigen::Vector2d& place,
                                   const std::vector<PatchMotion>& motions) const;

 private:
  /// A motion that a patch may have made, and how alike it is then.
  struct LikelyMotion {
    PatchMotion motion;
    double correlation = 0;
  };

  static std::vector<LikelyMotion> most_likely(std::vector<LikelyMotion> all);
  std::vector<LikelyMotion> likely_shifts(const Eigen::Vector2i& place,
                                          const Eigen::Vector2i& about) const;
  /// By what is refined of the likeliest of some motions.
  /// @param likely  in pixels of the reduced pictures
  std::optional<PatchMotion> found(
      const Eigen::Vector2d& place,
      const std::function<std::vector<LikelyMotion>(const ReferencePatch&)>& likely) const;

  GreyPicture first_, now_;
  SplinePicture first_spline_, now_spline_;
};

}  // namespace pliant
