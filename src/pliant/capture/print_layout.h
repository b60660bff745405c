#pragma once

#include "pliant/capture/pattern.h"

namespace pliant {

/// Left white at each edge of a sheet, where printers do not reach (m).
inline constexpr double kSheetMargin = 0.008;

/// A rectangle on a sheet (m), by its upper left corner as seen from the sheet's; y goes down.
struct SheetBox {
  double left = 0, top = 0, width = 0, height = 0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// A label of a clip, to cut out. Its lower side goes along the clip's edge.
struct LabelShape {
  double white = 0;              ///< around the tag: one of its cells (m)
  double width = 0, height = 0;  ///< with the number beside the tag (m)
};

LabelShape label_shape(const ClipCodes& clips);

/// Where the parts of a pattern are on its sheet.
struct PrintLayout {
  SheetBox pattern;       ///< a board from black edge to black edge, all labels, or the noise
  SheetBox strip;         ///< of the ruler and what is written beside it
  int labels_in_row = 0;  ///< of clips
  double label_gap = 0;   ///< between them (m)
};

/// The ruler that goes with a sheet: 100 mm, 50 mm or 20 mm.
/// @throws InputError where there is no room even for the last
double ruler_of_sheet(const Eigen::Vector2d& sheet);

/// @throws InputError that says what would go on the sheet, where the pattern does not
PrintLayout layout_of(const Pattern& pattern);

}  // namespace pliant
