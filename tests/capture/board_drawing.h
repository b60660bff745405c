#pragma once

#include "pliant/capture/camera_model.h"
#include "pliant/capture/printed_board.h"
#include "pliant/capture/view_drawing.h"

namespace pliant::test {

/// What a camera sees of a board on a white table.
/// @param pose  in rig axes
/// @param blur  pixels
inline GreyPicture draw_board(const CameraModel& camera, const TagBoard& board,
                              const RigidMotion& pose, double blur) {
  DrawnSurface surface = board_surface(board);
  for (auto place : surface.positions.colwise()) place = pose * Eigen::Vector3d(place);
  ViewOptions options;
  options.ambient = 1;
  options.background = 0.9;
  options.blur = blur;
  return draw_view(camera, {surface}, options);
}

}  // namespace pliant::test
