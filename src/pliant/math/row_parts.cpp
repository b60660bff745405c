#include "pliant/math/row_parts.h"

#include <numeric>

namespace pliant {

RowParts row_parts(const BlockPattern& pattern) {
  constexpr int kWorthIt = 1000;    // rows
  constexpr int kMostOfMiddle = 8;  // a part in so many of the rows
  const int size = pattern.size(), half = size / 2;
  std::vector<int> first, middle;
  for (int i = 0; i < half; ++i) {
    const bool reaches_over = pattern.column(pattern.row_end(i) - 1) >= half;
    (reaches_over ? middle : first).push_back(i);
  }
  RowParts parts;
  if (size < kWorthIt || static_cast<int>(middle.size()) > size / kMostOfMiddle) {
    parts.rows.resize(static_cast<size_t>(size));
    std::iota(parts.rows.begin(), parts.rows.end(), 0);
    parts.begin = {0, size, size, size};
    return parts;
  }
  parts.rows = first;
  for (int i = size - 1; i >= half; --i) parts.rows.push_back(i);
  parts.rows.insert(parts.rows.end(), middle.begin(), middle.end());
  const auto of_first = static_cast<int>(first.size());
  parts.begin = {0, of_first, of_first + size - half, size};
  return parts;
}

}  // namespace pliant
