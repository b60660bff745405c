#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/spline_picture.h"
#include "pliant/capture/tag_edges.h"

namespace pliant {

/// A coded tag (AprilTag, family tag36h11) that was found in a picture.
struct DetectedTag {
  int code = 0;  ///< 0 to 586
  /// Corners of its black square, pixels (column, row), the middle of the first pixel being (0, 0).
  /// Seen upright: lower left, lower right, upper right, upper left.
  TagCorners corners;
  TagCorners of_lines;  ///< see EdgeCorners
  /// Grey levels of 255 by which its cells lie from the threshold of black and white, on average.
  double margin = 0;
  int wrong_cells = 0;  ///< that were corrected

  Eigen::Vector2d middle() const { return corners.rowwise().mean(); }
  /// Nearer than `corners`, which know of no lens.
  TagCorners corners_by(const CameraModel& camera) const;
};

/// What counts as a tag.
///
/// Two codes of tag36h11 differ in at least 11 of 36 cells, in any turn. Of random squares one in
/// 29 million shows one of its 587 codes, one in 790,000 with a wrong cell, one in 44,000 with
/// two. Small tags in photographs have such cells, so both are taken; but what texture shows by
/// chance has cells that are neither black nor white, and with two wrong cells tags must be clear.
struct TagDetectorOptions {
  int most_wrong_cells = 2;
  double least_margin = 20;         ///< grey levels of 255: a tenth of the contrast of a print
  double least_margin_of_two = 50;  ///< with two wrong cells
  int reduced = 1;                  ///< times by which the picture is made smaller to look for them
};

/// The tags in a picture, by their codes. A code may come more than once; a mirrored tag is none.
/// Corners are where lines through the edges of the black square meet, which lie where the
/// brightness changes most.
/// @param picture  brightness, 0 to 1
std::vector<DetectedTag> detect_tags(const GreyPicture& picture,
                                     const TagDetectorOptions& options = {});

/// The same, where some codes are known to be there: large tags are found in a picture of half the
/// size, in a quarter of the time. It is the whole one where one of the codes is not.
std::vector<DetectedTag> detect_tags_of(const std::vector<int>& codes, const GreyPicture& picture);

/// The codes that a picture shows in its reflection: several in one that is mirrored, else none.
std::set<int> mirrored_codes(const GreyPicture& picture);

/// @throws InputError where a picture shows one of some codes in its reflection
void require_unmirrored(const GreyPicture& picture, const std::vector<int>& codes,
                        const std::string& file);

/// The tags of a picture by their codes.
struct TagsByCode {
  std::map<int, DetectedTag> once;
  std::set<int> twice;  ///< or more often
};

TagsByCode tags_by_code(const std::vector<DetectedTag>& tags);

/// Of each camera's picture of a frame, with corners as their lenses show them.
std::vector<TagsByCode> detect_tags(const std::vector<GreyPicture>& pictures,
                                    const std::vector<CameraModel>& cameras, int threads);

/// The cells of a tag as it is printed, without the white cells around it: 8 x 8, row 0 uppermost,
/// 1 where white; the outermost cells are black.
/// @param code  0 to 586
GreyPicture tag_cells(int code);

/// Codes of the family.
inline constexpr int kTagCodes = 587;

}  // namespace pliant
