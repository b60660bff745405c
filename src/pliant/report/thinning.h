#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pliant::report {

/// Which samples of a long series to draw so that its picture stays the same.
///
/// Kept are the ends, the samples of `must_keep` (reversals), and the lowest and the highest sample
/// of every stretch of equal length, so no peak is lost. Everything is kept of a series within the
/// budget; a `must_keep` longer than the budget is noise and does not bind.
/// @param values     the series, in drawing order
/// @param must_keep  increasing indices
/// @param budget     about how many samples to keep (at least 2)
/// @return increasing indices, at most budget + must_keep.size() + 2 of them
std::vector<std::size_t> thin_for_drawing(std::span<const double> values,
                                          std::span<const std::size_t> must_keep,
                                          std::size_t budget);

}  // namespace pliant::report
