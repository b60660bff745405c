#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/capture/bundle_adjustment.h"
#include "pliant/capture/calibration_board.h"
#include "pliant/io/document.h"

namespace pliant {

/// A camera as the user describes it.
struct RigCameraFile {
  std::string name;
  FreeIntrinsics free{};  ///< what of it is estimated
  Location where;
};

/// Pictures of boards. Those of one number show the same boards at the same time.
struct RigPictureSet {
  std::vector<std::vector<std::filesystem::path>> files;  ///< by camera; empty: took none
  Location where;
};

/// A length that the boards did not tell: between the middles of two tags, or the side of one.
struct SecondLength {
  int first = 0, second = 0;  ///< codes; equal: the side of its black square
  double length = 0;          ///< m
  bool on_board = false;      ///< the tags lie in the plane of the board that is seen with them
  Location where;
};

/// A board that lies on a levelled table, face up, in one picture.
struct LevelBoard {
  std::filesystem::path picture;
  Location where;
};

/// A plumb line, by two pixels of it in each of two cameras, the upper one first.
struct PlumbLine {
  struct Seen {
    int camera = 0;
    Eigen::Vector2d upper, lower;  ///< pixels
  };
  std::vector<Seen> seen;
  Location where;
};

using GravitySource = std::variant<std::monostate, LevelBoard, PlumbLine>;

/// What a rig/1 file says (docs/formats/rig.md). SI units.
struct RigFile {
  std::string file;
  std::vector<RigCameraFile> cameras;
  std::vector<std::filesystem::path> board_files;  ///< pattern/1, as the document names them
  std::vector<Location> where_boards;
  std::vector<CalibrationBoard> boards;  ///< what those files hold; see read_rig
  std::vector<RigPictureSet> pictures;
  bool warp = false;  ///< boards may be bent
  std::optional<SecondLength> second_length;
  GravitySource gravity;

  /// @return -1 where there is none of that name
  int camera(const std::string& name) const;
};

/// Reads the document and the files of its boards.
/// @throws InputError
RigFile read_rig(const std::filesystem::path& path);
/// The document alone: `boards` stays empty.
RigFile rig_of(const Document& document);

/// The choices of `distortion`, and which of a camera's numbers each lets free.
FreeIntrinsics free_intrinsics(const std::string& distortion);
inline constexpr const char* kDefaultDistortion = "k1 k2 p1 p2";

}  // namespace pliant
