#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pliant/report/labels.h"

namespace pliant {

/// Readings of a table as they are drawn before any fit: what is measured over what drives it.
struct Preview {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< what was understood of the file
  report::QuantityLabel driver, measured;
  struct Series {
    std::string specimen;
    std::vector<double> driver, measured;  ///< in the units of the labels, in the order measured
  };
  std::vector<Series> series;
};

/// One self-contained HTML page: the readings as loops, ways out and back told apart, and both
/// quantities row by row.
std::string preview_page(const Preview& preview);

}  // namespace pliant
