#pragma once

#include <vector>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/pattern.h"

#include "capture/tag_drawing.h"

namespace pliant::test {

/// Brightness of a board of tags on white paper.
class PrintedBoard {
 public:
  explicit PrintedBoard(const TagBoard& board) : board_(board) {
    for (int i = 0; i < board.tag_count(); ++i) cells_.push_back(tag_cells(board.first_code + i));
  }

  /// @param place  in the board's axes (m)
  float at(const Eigen::Vector2d& place) const {
    const double step = board_.tag + board_.gap;
    const int column = static_cast<int>(std::floor(place.x() / step));
    const int row_up = static_cast<int>(std::floor(place.y() / step));
    if (column < 0 || row_up < 0 || column >= board_.columns || row_up >= board_.rows) return 1;
    const Eigen::Vector2d within =
        (place - step * Eigen::Vector2d(column, row_up)) / board_.tag * kTagCells;
    if (within.maxCoeff() >= kTagCells) return 1;
    const GreyPicture& cells = cells_[(board_.rows - 1 - row_up) * board_.columns + column];
    return cells(kTagCells - 1 - static_cast<int>(within.y()), static_cast<int>(within.x()));
  }

 private:
  TagBoard board_;
  std::vector<GreyPicture> cells_;
};

/// What a camera sees of boards, each pixel the mean of 3 x 3 places of it.
/// @param poses  of the boards, in rig axes; all in one plane, that of the first
/// @param blur   pixels
inline GreyPicture draw_boards(const CameraModel& camera, const std::vector<PrintedBoard>& boards,
                               const std::vector<RigidMotion>& poses, double blur) {
  constexpr int kSamples = 3;
  const RigidMotion& plane = poses.front();
  const Eigen::Vector3d normal = plane.matrix().col(2);
  std::vector<Eigen::Isometry3d> to_board;
  for (const RigidMotion& pose : poses) to_board.push_back(pose.inverse().isometry());
  GreyPicture picture(camera.rows, camera.columns);
  for (int row = 0; row < camera.rows; ++row) {
    for (int column = 0; column < camera.columns; ++column) {
      float sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const auto ray = camera.ray({column - 0.5 + (i % kSamples + 0.5) / kSamples,
                                     row - 0.5 + (i / kSamples + 0.5) / kSamples});
        if (!ray) continue;
        const double distance =
            normal.dot(plane.translation - ray->from) / normal.dot(ray->direction);
        const Eigen::Vector3d point = ray->from + distance * ray->direction;
        float brightness = 1;
        for (std::size_t b = 0; b < boards.size(); ++b) {
          brightness = std::min(brightness, boards[b].at((to_board[b] * point).head<2>()));
        }
        sum += brightness;
      }
      picture(row, column) = 0.1f + 0.8f * sum / (kSamples * kSamples);
    }
  }
  return blurred(picture, blur);
}

}  // namespace pliant::test
