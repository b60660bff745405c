#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/space_labels.h"
#include "pliant/capture/stereo_rest.h"

namespace pliant {

/// Points of a sample that several calibrated cameras have seen, in the axes of the sample: u, v
/// and off its plane.
///
/// In the first pictures patches of the first camera are found again in those of the others. From
/// then on each camera follows its own patches from its own first picture, so that nothing adds up;
/// a point is where the lines of sight of all that see it meet best.
class SpacePoints : public PointSource {
 public:
  /// @throws InputError where the cameras do not see the sample, or not the same
  SpacePoints(const DicFile& dic, ReadPicture read_picture, const RunContext& context);

  int count() const override;
  bool in_space() const override { return true; }
  double patch() const override;
  std::string file(int frame) const override;
  PointFrame read(int frame) override;
  std::vector<std::string> notes() const override;
  std::optional<Eigen::Vector3d> gravity() const override;

 private:
  /// What one camera follows.
  struct View {
    std::unique_ptr<PatchTracker> tracker;
    std::vector<int> points;  // of each of its patches
  };

  const DicViews& views() const { return *dic_.views; }
  std::vector<GreyPicture> pictures(int frame) const;
  void require_sight(const StereoRest& rest) const;
  void place_sample(const StereoRest& rest);
  void begin_views(const StereoRest& rest, std::vector<GreyPicture> pictures);
  /// Says what the pictures lack, or nothing.
  std::string follow(int frame);
  Pose in_sample(const Pose& motion) const;

  const DicFile& dic_;
  ReadPicture read_picture_;
  RunContext context_;
  std::vector<View> follow_;      // by camera
  std::vector<RestPoint> rest_;   // in rig axes
  Eigen::Isometry3d to_sample_;   // from rig axes
  double rest_miss_ = 0;          // median, of points at rest (pixels)
  Eigen::Vector2d corner_sides_;  // mean distances of the corners along weft and warp (m)
  int lost_at_rest_ = 0;
  std::unique_ptr<SpaceLabels> labels_;          // null without labels
  std::vector<std::optional<AgreedPoint>> now_;  // of each point
  std::vector<std::optional<Pose>> clips_;       // in rig axes
  int frame_ = 0;
};

}  // namespace pliant
