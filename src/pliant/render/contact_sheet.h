#pragma once

#include <vector>

#include "pliant/render/image.h"

namespace pliant {

/// How the pictures of a contact sheet are arranged.
struct SheetLayout {
  int columns = 1;
  int rows = 1;
};

/// As many columns as rows, or one or two more.
/// @param count  pictures, > 0
SheetLayout sheet_layout(int count);

/// Pictures side by side, row after row, on white.
/// @param pictures     one or more, of one size, as many as there is room for
/// @param right_margin  pixels left free at the right edge, for a legend
Image contact_sheet(const std::vector<Image>& pictures, const SheetLayout& layout,
                    int right_margin);

/// Of times in ascending order, `count` (or all, where there are fewer) that are spread evenly, the
/// first and the last among them: their places in the list.
/// @param count  > 0; of one picture it is the last
std::vector<int> evenly_in_time(const std::vector<double>& times, int count);

}  // namespace pliant
