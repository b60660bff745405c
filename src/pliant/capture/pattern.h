#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "pliant/io/document.h"

namespace pliant {

/// A tag's black square is so many cells wide; the white around it needs to be one of them.
inline constexpr int kTagCells = 8;

/// A calibration board: a grid of AprilTags (tag36h11) whose codes count up by one, row by row as
/// one reads.
///
/// The board's axes: x to the right and y up as one looks at the print, z towards who looks. Its
/// origin is the lower left corner of the lower left tag.
struct TagBoard {
  int columns = 6, rows = 8;
  double tag = 0.020;  ///< side of the black square (m)
  double gap = 0.005;  ///< from one black square to the next (m)
  int first_code = 0;  ///< of the upper left tag

  int tag_count() const { return columns * rows; }
  bool has(int code) const { return code >= first_code && code < first_code + tag_count(); }
  /// Corners of a black square in board axes (m), z = 0, in libapriltag's order: counter-clockwise
  /// from the lower left one, as one sees the upright tag.
  /// @param code  of the board
  std::array<Eigen::Vector3d, 4> corners(int code) const;
  /// From the left edge of the first black square to the right edge of the last, and the same for
  /// rows (m).
  Eigen::Vector2d extent() const;
};

/// A calibration board of black and white squares, the upper left one black.
///
/// The board's axes are those of TagBoard; their origin is the lower left inner corner. Where one
/// of columns and rows is odd and the other even, the board shows which side is up.
struct Chessboard {
  int columns = 9, rows = 6;  ///< of inner corners; there is one square more of each
  double square = 0.020;      ///< side (m)

  int corner_count() const { return columns * rows; }
  bool shows_up() const { return (columns + rows) % 2 != 0; }
  /// An inner corner in board axes (m), z = 0.
  /// @param number  row by row as one reads: 0 is the upper left one
  Eigen::Vector3d corner(int number) const;
  /// From the left edge of the first square to the right edge of the last, and the same for rows.
  Eigen::Vector2d extent() const;
};

/// Tags to cut out and put on clips.
///
/// A label's axes are those of TagBoard, its origin is the middle of its tag. The edge of the clip,
/// or of the jaw, from which the cloth comes goes along the line y = -edge.
struct ClipCodes {
  double tag = 0.015;   ///< side of the black square (m)
  double edge = 0.015;  ///< from the tag's middle down to the line of the clip's edge (m)
  std::vector<int> codes;

  bool has(int code) const;
};

/// Irregular texture for cloth: band-limited noise.
struct ClothPattern {
  std::uint64_t seed = 0;
  double camera = 0.25e-3;  ///< length of a camera's pixel on the cloth (m)
  double finest = 1e-3;     ///< no wave of the noise is shorter (m)
  int octaves = 4;          ///< each with waves twice as long as the one before
  double dpi = 600;         ///< of the noise as it was drawn (dots per inch)
};

/// What is on a printed sheet (pattern/1, docs/formats/pattern.md). Lengths are those of the print.
struct Pattern {
  std::string file;  ///< as the user named it; empty for one that was not read
  std::variant<TagBoard, Chessboard, ClipCodes, ClothPattern> kind;
  Eigen::Vector2d sheet = {0.210, 0.297};  ///< its width and height (m)
  double ruler = 0.100;                    ///< length of the drawn ruler (m)
  /// Length of the ruler on the print, where somebody measured it: printers shrink and stretch.
  /// Other lengths of what is read are those drawn times `measured_ruler / ruler`.
  std::optional<double> measured_ruler;
};

/// Reads what was drawn, and scales it to the ruler as it was measured.
/// @throws InputError
Pattern read_pattern(const std::filesystem::path& path);
Pattern pattern_of(const Document& document);

/// A pattern/1 document of a pattern whose ruler nobody has measured yet.
std::string pattern_text(const Pattern& pattern);

/// "board", "chessboard", "clips" or "cloth": the key under which a document tells it.
std::string kind_name(const Pattern& pattern);

}  // namespace pliant
