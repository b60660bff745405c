#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/dic_views.h"
#include "pliant/io/fields.h"

namespace pliant {

/// A load cell, and the cord by which it pulls a clip.
struct DicCell {
  std::string cord;               ///< its name
  std::string clip;               ///< that it pulls
  std::string column;             ///< of the log
  double tare = 0;                ///< what the cell reads without load (N)
  double slope = 1;               ///< true force over that reading, less the tare
  std::filesystem::path picture;  ///< in which the cord is pointed at
  Eigen::Vector2d from, to;       ///< there: where it is fastened to the clip, and away (pixels)
  Location where, where_picture;
  // Of the views:
  std::size_t camera = 0;
  int frame = 0;
};

/// `cells` of the forces of a dic/1 file; which camera and frame a picture is of is not there yet.
/// @throws InputError
std::vector<DicCell> read_cells(const Value& value);
/// @throws InputError for two cords of one name at a clip, and for one that is hardly pointed at
void require_single_cords(const std::vector<DicCell>& cells);
/// Finds the pictures among those of the views.
/// @throws InputError
void resolve_cells(std::vector<DicCell>& cells, const DicViews& views);

}  // namespace pliant
