#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/capture/camera_model.h"
#include "pliant/capture/view_drawing.h"
#include "pliant/measurement/session.h"
#include "pliant/study/virtual_cameras.h"

namespace pliant {

/// The cords of a frame as they are drawn, those that pull at all: white, straight, round.
std::vector<DrawnSurface> cord_surfaces(const SessionFrame& frame);

/// What load cells beside the cameras write of a session's cords: its frames are the pictures after
/// the first, in which nothing pulls.
class VirtualCells {
 public:
  /// @param random  draws tare and slope of each cell, what it reads wrongly, and by how much a
  ///                user points beside a cord
  VirtualCells(const Session& session, const VirtualCameras& options, const RandomStream& random);

  bool empty() const { return cells_.empty(); }
  /// A table with the time and a column a cell.
  std::string log() const;
  /// `forces` of a dic/1 file.
  /// @param file     of the log
  /// The file of a camera's picture of a frame of the session.
  using NamePicture = std::function<std::string(std::size_t camera, int frame)>;
  /// @throws InputError where no camera sees a cord
  std::string forces_yaml(const std::string& file, const std::vector<CameraModel>& cameras,
                          const NamePicture& picture) const;

  /// Both ends of a cord in a picture (pixels).
  struct ShownCord {
    Eigen::Vector2d from, to;

    double length() const { return (to - from).norm(); }
  };

 private:
  struct Cell {
    std::size_t clip = 0;
    std::string cord;
    double tare = 0, slope = 1;  // as of DicCell

    std::string column(const Session& session) const;
  };

  /// Where a user points at a cord.
  struct PointedView {
    int frame = 0;
    std::size_t camera = 0;
    ShownCord shown;
  };

  /// In the first frame in which it pulls and is seen, by the camera that shows most of it.
  PointedView pointed_view(const Cell& cell, const std::vector<CameraModel>& cameras) const;
  double pull(const Cell& cell, int frame) const;
  double pull_at(const Cell& cell, double time) const;

  const Session& session_;
  const VirtualCameras& options_;
  RandomStream random_;
  std::vector<Cell> cells_;
};

}  // namespace pliant
