#pragma once

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/pattern.h"
#include "pliant/capture/tag_detector.h"

namespace pliant {

/// A board that cameras are calibrated with.
struct CalibrationBoard {
  std::string name;
  std::variant<TagBoard, Chessboard> kind;

  /// Of tags: four of each, in the order of codes; of a chessboard: row by row.
  /// @return m, in the board's axes; one column a corner, z = 0
  Eigen::Matrix3Xd corners() const;
  bool is_chessboard() const { return std::holds_alternative<Chessboard>(kind); }
};

/// What of a board is seen in a picture.
struct BoardView {
  int board = 0;              ///< number in the list of boards
  std::vector<int> corners;   ///< their numbers
  Eigen::Matrix2Xd pixels;    ///< one column a corner
  Eigen::Matrix2Xd of_lines;  ///< of tags: see EdgeCorners; of a chessboard: none
};

/// What a picture shows.
struct PictureFindings {
  std::vector<BoardView> boards;
  std::vector<DetectedTag> other_tags;  ///< that belong to no board; each code once
  std::string problem;                  ///< why no board was taken from it; else empty
};

/// Looks for boards in a picture. Codes that are seen twice are left out.
/// @param picture  brightness, 0 to 1
PictureFindings find_boards(const GreyPicture& picture,
                            const std::vector<CalibrationBoard>& boards);

}  // namespace pliant
