#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/dic_session.h"

namespace pliant {

/// A picture of a frame, made small, and where it shows the mesh.
struct ShownView {
  int frame = 0;
  std::string camera;
  std::string png;  ///< bytes of a file
  int columns = 0, rows = 0;
  Eigen::Matrix2Xd vertices;  ///< in its pixels; NaN of those that were not seen
};

/// The views of a session with their pictures.
/// @throws InputError where a picture cannot be read any more
std::vector<ShownView> shown_views(const DicSession& made, const ReadPicture& read_picture);

}  // namespace pliant
