#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pliant/capture/fixed_tags.h"
#include "pliant/capture/label_views.h"
#include "pliant/capture/match_noise.h"
#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/plane_view.h"
#include "pliant/capture/point_source.h"

namespace pliant {

/// Points of a flat sample that one camera has seen: from straight in front, or as labels on the
/// clips tell: patches of the first picture that are found again in every other one.
class TrackedPoints : public PointSource {
 public:
  /// @throws InputError where the sample does not lie in the first picture, or most of it has no
  ///         texture
  TrackedPoints(const DicFile& dic, ReadPicture read_picture, const RunContext& context);

  bool in_space() const override { return false; }
  double patch() const override;
  PointFrame read(int frame) override;
  std::vector<std::string> notes() const override;
  std::vector<std::string> warnings() const override;
  std::vector<std::string> cameras() const override { return {"camera"}; }
  std::vector<PointsInPicture> in_pictures(const Eigen::Matrix3Xd& points) const override;

 private:
  /// Between the edges of clips, as labels say it, and as the file does (m).
  struct LabelledSize {
    const char* which;  ///< "wide" or "high"
    double seen, stated;
  };
  std::vector<LabelledSize> sizes_by_labels() const;
  void require_size() const;
  void place_patches();
  GreyPicture picture(int frame) const;
  std::string track(int frame);
  PointFrame points() const;

  const DicFile& dic_;
  ReadPicture read_picture_;
  RunContext context_;
  std::unique_ptr<LabelViews> labels_;  // null without labels
  std::optional<FixedTags> fixed_;
  PlaneView first_, now_;
  double label_squares_ = 0;  // of the misses of all views since the first (pixels)
  int views_ = 0;
  std::unique_ptr<PatchTracker> tracker_;
  std::optional<MatchCheck> check_;
  MatchMisses matches_;  // of this frame
  MatchNoise noise_;
  std::string moved_;  // what fixed tags say of this frame's picture
  std::string doubt_;  // of it
  int without_texture_ = 0;
  std::vector<std::string> warnings_;
  int frame_ = 0;
};

}  // namespace pliant
