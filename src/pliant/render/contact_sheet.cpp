#include "pliant/render/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

/// The place of the time nearest to `time` among those from `first` to `last`.
int nearest(const std::vector<double>& times, double time, int first, int last) {
  const auto begin = times.begin() + first, end = times.begin() + last + 1;
  const auto above = std::lower_bound(begin, end, time);
  if (above == end) return last;
  if (above == begin) return first;
  const bool below_is_nearer = time - *(above - 1) <= *above - time;
  return static_cast<int>((below_is_nearer ? above - 1 : above) - times.begin());
}

}  // namespace

SheetLayout sheet_layout(int count) {
  PLIANT_ASSERT(count > 0, "a sheet has pictures");
  SheetLayout layout;
  layout.rows = std::max(1, static_cast<int>(std::lround(std::sqrt(0.8 * count))));
  layout.columns = (count + layout.rows - 1) / layout.rows;
  return layout;
}

Image contact_sheet(const std::vector<Image>& pictures, const SheetLayout& layout,
                    int right_margin) {
  PLIANT_ASSERT(std::ssize(pictures) <= long(layout.columns) * layout.rows, "all have a place");
  const int width = pictures.front().width(), height = pictures.front().height();
  Image sheet(layout.columns * width + right_margin, layout.rows * height);
  for (int i = 0; const Image& picture : pictures) {
    paste(sheet, picture, i % layout.columns * width, i / layout.columns * height);
    ++i;
  }
  return sheet;
}

std::vector<int> evenly_in_time(const std::vector<double>& times, int count) {
  PLIANT_ASSERT(count > 0 && !times.empty(), "pictures are chosen among frames");
  const int last = static_cast<int>(times.size()) - 1;
  const int chosen = std::min(count, last + 1);
  if (chosen == 1) return {last};
  std::vector<int> places;
  for (int i = 0; i < chosen; ++i) {
    const double time = times.front() + (times.back() - times.front()) * i / (chosen - 1);
    // Enough frames are left free on both sides for the pictures before and after this one.
    const int first_free = places.empty() ? 0 : places.back() + 1;
    places.push_back(nearest(times, time, first_free, last - (chosen - 1 - i)));
  }
  return places;
}

}  // namespace pliant
