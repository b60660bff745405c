#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pliant/capture/label_views.h"
#include "pliant/capture/local_motion.h"
#include "pliant/capture/plane_view.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/reference_patch.h"

namespace pliant {

/// Points of a flat sample that one camera has seen: from straight in front, or as labels on the
/// clips tell. Each is a patch of the first picture that is found again in every other one. It is
/// always the first picture that is matched, so that nothing adds up from frame to frame.
///
/// A patch is looked for where it was in the frame before, and if it is not there where the patches
/// around it have gone; where most are lost, a few are searched for far around, and lead the
/// others. One that has gone elsewhere than those around it counts as lost.
class TrackedPoints : public PointSource {
 public:
  /// @throws InputError where the sample does not lie in the first picture, or most of it has no
  ///         texture
  TrackedPoints(const DicFile& dic, ReadPicture read_picture, const RunContext& context);

  int count() const override { return static_cast<int>(dic_.pictures->files.size()); }
  bool in_space() const override { return false; }
  std::string file(int frame) const override;
  PointFrame read(int frame) override;
  std::vector<std::string> notes() const override;

 private:
  struct Tracked {
    Eigen::Vector2d place;  // pixels
    ReferencePatch patch;
    PatchMotion motion;      // when it was seen last
    double correlation = 1;  // then
    bool is_seen = true;
  };

  struct Found {
    Eigen::Matrix2Xd rest, now;  // pixels
  };

  void place_patches(const SplinePicture& rest);
  GreyPicture picture(int frame) const;
  std::string track(int frame);
  void match_where_they_were(const SplinePicture& now);
  bool match_beside_found(const SplinePicture& now, double steps);
  void search_far(const GreyPicture& grey, const SplinePicture& now);
  Found found() const;
  /// Of the points that were found (pixels).
  LocalMotion motion_of_found(double reach) const;
  void look_for(Tracked& point, const SplinePicture& now, const PatchMotion& start) const;
  void leave_out_strays();
  int seen() const;
  PointFrame points() const;

  const DicFile& dic_;
  ReadPicture read_picture_;
  RunContext context_;
  GreyPicture rest_;
  std::unique_ptr<LabelViews> labels_;  // null without labels
  PlaneView first_, now_;
  double label_squares_ = 0;  // of the misses of all views since the first (pixels)
  int views_ = 0;
  std::vector<Tracked> tracked_;
  int without_texture_ = 0;
  int frame_ = 0;
};

/// A picture whose pixels are the means of squares of `factor` x `factor`.
GreyPicture reduced(const GreyPicture& picture, int factor);

/// Where a patch has gone by whole pixels: the largest correlation within `reach`.
/// @return nothing where it leaves the picture everywhere, or nowhere correlates by a half
std::optional<Eigen::Vector2i> coarse_shift(const GreyPicture& rest, const GreyPicture& now,
                                            const Eigen::Vector2i& place, int radius, int reach);

}  // namespace pliant
