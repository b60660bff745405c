#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/capture/cord_line.h"
#include "pliant/capture/cord_look.h"
#include "pliant/capture/dic_file.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// The cords of a frame, in rig axes.
struct FrameCords {
  std::vector<std::optional<CordLine>> lines;  ///< of each cell; nothing before it was pointed at
  std::string missing;                         ///< the cord that two cameras should see, or nothing
};

/// Cords that load cells pull, followed from where a user pointed at them: straight lines in space,
/// each fastened to a place of its clip.
class SpaceCords {
 public:
  /// @param dic      outlives the cords; its clips of cords carry labels
  /// @param to_rig   from the sample's axes
  /// @param rest     3 x points of the sample in the first pictures, rig axes (m)
  SpaceCords(const DicFile& dic, const Eigen::Isometry3d& to_rig, const Eigen::Matrix3Xd& rest,
             int threads);

  /// A frame in which a user points at a cord may not be left out.
  /// @param why  it would be
  /// @throws InputError where one does
  void require_free(int frame, const std::string& why) const;

  /// @param pictures  of each camera
  /// @param clips     how they have moved since the first pictures, rig axes
  /// @throws InputError where no cord is seen to which the user has pointed, or that of another
  /// cell
  FrameCords follow(int frame, const std::vector<GreyPicture>& pictures,
                    const std::vector<std::optional<Pose>>& clips);

 private:
  struct Cord {
    std::size_t clip = 0;
    Eigen::Vector3d beside = Eigen::Vector3d::Zero();  // the sample beside the clip at rest (m)
    CordLook look;
    Eigen::Vector3d fastened = Eigen::Vector3d::Zero();  // on the clip at rest (m)
    std::optional<CordLine> last;
  };

  void point_at(const DicCell& cell, Cord& cord, const CordViews& views, const Pose& pose) const;
  /// Of cells that point at their cords in this frame.
  void require_own_cords(int frame, const std::vector<std::optional<CordLine>>& lines) const;

  const DicFile& dic_;
  Eigen::Isometry3d to_rig_;
  int threads_;
  std::vector<Cord> cords_;  // of each cell
};

}  // namespace pliant
