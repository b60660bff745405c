#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/capture/local_motion.h"
#include "pliant/capture/reference_patch.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// A patch of a picture that is looked for in others.
struct TrackedPatch {
  Eigen::Vector2d place;  ///< of its middle in the first picture (pixels)
  ReferencePatch patch;
  std::optional<ReferencePatch> core = {};  ///< its middle, half as wide, once that was needed
  bool lacks_core = false;                  ///< that has no texture to be found by
  PatchMotion motion = {};                  ///< when it was seen last
  double correlation = 1;                   ///< then
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of its place then (pixels^2)
  bool is_seen = true;
  bool by_core = false;  ///< it was the middle alone that was seen then

  Eigen::Vector2d now() const { return place + motion.shift; }
  /// Standard deviation of a coordinate of it (pixels).
  double noise() const { return std::sqrt(covariance.trace() / 2); }
};

/// The patches that were found in a picture.
struct FoundPatches {
  std::vector<int> numbers;
  Eigen::Matrix2Xd places, now;  ///< in the first picture and in this one (pixels)
};

/// Motions that the surroundings of a place may have made (pixels).
using MotionCandidates = std::function<std::vector<PatchMotion>(const Eigen::Vector2d& place)>;

/// Patches of one picture that are found again in others. It is always the first picture that is
/// matched, so that nothing adds up from picture to picture.
///
/// A patch is looked for where it was in the picture before, and if it is not there where the
/// patches around it have gone; where half are lost at once, a few are searched for far around, and
/// lead the others, if there is no second place that is as much like them. One that has gone
/// elsewhere than those around it counts as lost.
///
/// Where cloth is bent within a patch, or part of it is hidden, its middle is looked for alone.
class PatchTracker {
 public:
  /// @param radius  patches have 2 radius + 1 pixels a side
  /// @param step    pixels from patch to patch
  PatchTracker(GreyPicture first, int radius, double step, const RunContext& context);

  /// @return false, and none is added, where the picture has no texture to be found again
  bool add(const Eigen::Vector2d& place);

  /// In the next picture of the same camera. The journal of the run answers what was found there
  /// before it was stopped.
  void follow(const GreyPicture& now);
  /// In a picture of another camera: a few patches are looked for along the candidates.
  /// @param apart  pixels from candidate to candidate, at most
  void find_across(const GreyPicture& now, const MotionCandidates& candidates);

  const GreyPicture& first() const { return first_; }
  const SplinePicture& first_spline() const { return first_spline_; }
  /// The picture that was followed last, smoothed like the first; there is one.
  const SplinePicture& now() const { return *now_; }
  int radius() const { return radius_; }
  /// Pixels along a side of what was seen of a patch.
  int side(const TrackedPatch& patch) const;
  const std::vector<TrackedPatch>& patches() const { return tracked_; }
  int count() const { return static_cast<int>(tracked_.size()); }
  int seen() const;
  FoundPatches found() const;

 private:
  /// Of the patches as they were added, and of how they are followed.
  std::string digest() const;
  /// Takes what the journal knows of a picture, else what `find` finds there.
  /// @param starts  digest of where it is told to look
  void recall_or(const GreyPicture& picture, const std::string& starts,
                 const std::function<void()>& find);
  void look_for(TrackedPatch& point, const SplinePicture& now, PatchMotion start) const;
  /// The middle alone; whether it is there, and alike by `least` or more.
  bool look_for_core(TrackedPatch& point, const SplinePicture& now, PatchMotion start,
                     double least) const;
  bool has_jumped(const SplinePicture& now);
  void match_where_they_were(const SplinePicture& now);
  /// How a patch has moved, within some pixels.
  using StartOf = std::function<std::optional<PatchMotion>(const TrackedPatch&)>;
  /// For some patches alone.
  void search(const SplinePicture& now, const StartOf& start_of);
  bool match_beside_found(const SplinePicture& now, double steps);
  bool match_beside_neighbour(const SplinePicture& now);
  void spread(const SplinePicture& now);
  /// Whether a patch has not been looked for there since it was lost.
  bool is_new(int patch, const PatchMotion& start);
  LocalMotion motion_of_found(double reach) const;
  double most_unlike() const;
  void see_bent_by_cores(const SplinePicture& now);
  void leave_out_strays();

  GreyPicture first_;
  SplinePicture first_spline_;
  std::optional<SplinePicture> now_;
  int radius_;
  double step_;
  RunContext context_;
  std::string digest_;  // once it was needed
  std::vector<TrackedPatch> tracked_;
  std::vector<std::optional<PatchMotion>> tried_;  // of each patch, in this picture
};

}  // namespace pliant
