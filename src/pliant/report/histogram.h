#pragma once

#include <span>
#include <vector>

namespace pliant::report {

/// Counts in bins of equal width.
struct Histogram {
  std::vector<double> centres;
  std::vector<double> counts;
  double bin_width = 0.0;
};

/// Counts `values` in `bins` bins between `low` and `high`; values outside count in the end bins.
/// Empty where there is no value or no range.
Histogram make_histogram(std::span<const double> values, double low, double high, int bins);

}  // namespace pliant::report
