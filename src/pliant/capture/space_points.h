#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/capture/calibration_error.h"
#include "pliant/capture/fixed_tags.h"
#include "pliant/capture/match_noise.h"
#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/sample_placement.h"
#include "pliant/capture/space_cords.h"
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

  bool in_space() const override { return true; }
  double patch() const override;
  PointFrame read(int frame) override;
  std::vector<std::string> notes() const override;
  std::vector<std::string> warnings() const override;
  std::optional<Eigen::Vector3d> gravity() const override;
  std::vector<std::string> cameras() const override { return views().names; }
  std::vector<PointsInPicture> in_pictures(const Eigen::Matrix3Xd& points) const override;
  std::vector<RegionMisses> misses() const override { return misses_; }

 private:
  /// Of a point, by camera.
  using SeenPlaces = std::vector<std::optional<SeenPlace>>;
  /// What one camera follows.
  struct View {
    std::unique_ptr<PatchTracker> tracker;
    std::optional<MatchCheck> check;
    MatchNoise noise;
    std::vector<int> points;  // of each of its patches
  };

  const DicViews& views() const { return *dic_.views; }
  std::vector<GreyPicture> pictures(int frame) const;
  void require_sight(const StereoRest& rest) const;
  Eigen::Vector2d size() const;
  Eigen::Matrix3Xd rest_positions() const;
  void find_sample();
  void tell_errors();
  /// Of each camera; none where nothing asks for them.
  std::vector<TagsByCode> tags_in(const std::vector<GreyPicture>& pictures) const;
  void begin_fixed(const std::vector<GreyPicture>& pictures, const std::vector<TagsByCode>& tags);
  void begin_cords(const std::vector<GreyPicture>& pictures);
  void begin_views(std::vector<GreyPicture> pictures);
  /// Says what the pictures lack, or nothing.
  std::string follow(int frame);
  /// What fixed tags say of one of the cameras, or nothing.
  std::string moved_camera(const std::vector<TagsByCode>& tags) const;
  std::vector<SeenPlaces> seen_in(const std::vector<GreyPicture>& pictures) const;
  void note_agreement(const std::vector<SeenPlaces>& seen);
  void note_misses(const std::vector<SeenPlaces>& seen);
  Pose in_sample(const Pose& motion) const;
  std::optional<CordLine> in_sample(std::optional<CordLine> line) const;
  /// By how much a point is put elsewhere in the sample's axes, which move along.
  /// @param errors  its displacements by errors of the calibration, in rig axes
  Eigen::Matrix3Xd in_moved_axes(const Eigen::Vector3d& position,
                                 const Eigen::Matrix3Xd& errors) const;
  SightQuality quality() const;
  /// Of points that are seen now: standard deviations by the noise of pictures and by errors of the
  /// calibration, in the sample's axes (m).
  Eigen::Matrix3Xd deviations(const std::vector<std::size_t>& seen, const PointFrame& points) const;

  const DicFile& dic_;
  ReadPicture read_picture_;
  RunContext context_;
  std::vector<View> follow_;     // by camera
  std::vector<RestPoint> rest_;  // in rig axes
  SamplePlacement placement_;
  CalibrationError calibration_;
  std::vector<Eigen::Matrix3Xd> rest_errors_;   // of each point, by the calibration (m)
  std::vector<Eigen::Isometry3d> axes_errors_;  // from rig axes, under each error of it
  double rest_miss_ = 0;                        // median, of points at rest (pixels)
  int lost_at_rest_ = 0;
  std::vector<std::string> warnings_;
  std::unique_ptr<SpaceLabels> labels_;          // null without labels
  std::vector<FixedTags> fixed_;                 // of each camera; empty without such tags
  std::vector<std::optional<AgreedPoint>> now_;  // of each point
  Eigen::VectorXd sides_;                        // of their squares when they were seen (pixels)
  double agreeing_ = 1;                          // as of SightQuality
  MatchMisses matches_;                          // of this frame
  std::string moved_, doubt_;                    // of a picture of it
  std::vector<RegionMisses> misses_;             // of each camera
  std::vector<std::optional<Pose>> clips_;       // in rig axes
  std::unique_ptr<SpaceCords> cords_;            // null without cells
  std::vector<std::optional<CordLine>> lines_;   // of their cords, in rig axes
  int frame_ = 0;
};

}  // namespace pliant
