#include "pliant/report/histogram.h"

#include <algorithm>

namespace pliant::report {

Histogram make_histogram(std::span<const double> values, double low, double high, int bins) {
  Histogram histogram;
  if (values.empty() || bins < 1 || !(high > low)) return histogram;
  histogram.bin_width = (high - low) / bins;
  histogram.counts.assign(static_cast<std::size_t>(bins), 0.0);
  for (int bin = 0; bin < bins; ++bin) {
    histogram.centres.push_back(low + (bin + 0.5) * histogram.bin_width);
  }
  for (const double value : values) {
    // Clamped as a double: a far outlier would overflow an int.
    const double bin = std::clamp((value - low) / histogram.bin_width, 0.0, bins - 1.0);
    histogram.counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  return histogram;
}

}  // namespace pliant::report
