#pragma once

#include <numbers>
#include <utility>

#include "pliant/io/fields.h"

namespace pliant {

/// Cameras that look at the sheet of a virtual session, and the pictures they take (`cameras` of a
/// lab/1 file).
struct VirtualCameras {
  int count = 4;
  int columns = 1280, rows = 1024;           ///< of a picture
  double pixel = 0.25e-3;                    ///< on the sheet (m)
  double distance = 0.5;                     ///< from its middle (m)
  double angle = std::numbers::pi / 9;       ///< off its normal (rad)
  double blur = 0.7;                         ///< pixels, standard deviation
  double read_noise = 0.01, shot_noise = 0;  ///< of white
  int bits = 8;                              ///< of a grey level
  double gloss = 0;                          ///< of the cloth: of the light, mirrored
  int boards = 20;                           ///< pictures of the calibration board
  double cell_noise = 2e-3;                  ///< of a row of the cells' log (N)
  double log_start = 2;                      ///< of the first picture by the cells' clock (s)
};

/// @throws InputError
VirtualCameras read_virtual_cameras(const Value& value);

}  // namespace pliant
