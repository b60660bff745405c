#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/report/prediction.h"

namespace pliant::report {

/// The rows where a stretch of loading, unloading or rest begins or ends, or the specimen changes.
std::vector<std::size_t> reversal_rows(const Prediction& prediction);

/// The rows to draw of an experiment so that the picture of `values` stays the same.
std::vector<std::size_t> rows_to_draw(const Prediction& prediction, std::span<const double> values,
                                      std::size_t budget);

/// A line through some rows with a gap (NaN) between stretches.
struct BrokenLine {
  std::vector<double> x, y;
};

/// The line of one branch: each stretch starts where the stretch before it ended, so that loading
/// and unloading meet at the reversal.
/// @param rows  increasing row numbers
BrokenLine line_of_branch(const Prediction& prediction, std::span<const std::size_t> rows,
                          Branch branch, std::span<const double> x, std::span<const double> y);

}  // namespace pliant::report
