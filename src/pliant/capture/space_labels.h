#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/dic_file.h"
#include "pliant/capture/spline_picture.h"
#include "pliant/capture/tag_detector.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// How clips have moved since the first pictures, by their labels, in rig axes.
struct LabelledMotions {
  std::vector<std::optional<Pose>> clips;  ///< of a dic/1 file; nothing of those without labels
  std::string missing;  ///< the clip whose labels two cameras should see, where they do not
};

/// A label in the pictures of a camera.
struct LabelSightings {
  int seen = 0;      ///< frames in which the camera showed it
  int off = 0;       ///< of them those in which it was elsewhere than its clip
  double worst = 0;  ///< by how much, at most (pixels)

  /// In a tenth of the frames, and in two.
  bool is_off() const { return off >= 2 && 10 * off >= seen; }
};

/// Clips by labels that several cameras see: the corners of a label's black square are points of
/// the clip, which is rigid. How large it is need not be known.
class SpaceLabels {
 public:
  /// @param dic    outlives the labels; its clips name their codes
  /// @param first  a picture of each camera
  /// @param tags   that they show
  /// @throws InputError where two cameras do not see each label, one sees a label twice or
  ///         mirrored, or their lines of sight do not meet
  SpaceLabels(const DicFile& dic, const std::vector<GreyPicture>& first,
              const std::vector<TagsByCode>& tags);

  /// @param seen  by each camera in a later frame
  LabelledMotions motions(const std::vector<TagsByCode>& seen);
  /// Of labels that a camera saw elsewhere than their clip; of cameras that saw most of them so,
  /// and of clips most of whose labels were.
  std::vector<std::string> warnings() const;

 private:
  using Corners = Eigen::Matrix<double, 3, 4>;
  using SeenTags = std::vector<TagsByCode>;  // of each camera

  void require_labels(const std::vector<GreyPicture>& first, const SeenTags& tags) const;
  /// Why no label of a clip is seen by two cameras.
  std::string missing(const DicClip& clip, const SeenTags& tags) const;
  /// Of the codes of the file's clips that two cameras see.
  std::map<int, Corners> corners(const SeenTags& tags) const;
  /// By the corners that two cameras see, and from there by all that any sees.
  Pose pose_of(const std::vector<int>& codes, const std::map<int, Corners>& now,
               const SeenTags& tags) const;
  /// Sightings of a clip's labels.
  struct OffLabels {
    int seen = 0;    ///< labels and cameras that see them
    int off = 0;     ///< of them those that are elsewhere than the clip
    int labels = 0;  ///< that are so for some camera
  };
  /// By one camera, or by all.
  OffLabels off_labels(const DicClip& clip, std::optional<std::size_t> camera) const;
  /// The sightings of a label by a camera; nothing where it was not seen.
  const LabelSightings* sightings_of(int code, std::size_t camera) const;
  bool is_torn(const DicClip& clip) const;
  bool is_moved(std::size_t camera) const;
  /// Tells labels that do not move with their clip.
  void note_misses(const std::vector<int>& codes, const Pose& pose, const SeenTags& tags);

  const DicFile& dic_;
  std::map<int, Corners> first_;
  std::map<int, std::vector<LabelSightings>> sightings_;  // by code and camera
};

}  // namespace pliant
