#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/report_data.h"

namespace pliant::report {

/// The experiments whose loops matter most: component by component one that was fitted and beside
/// it one that was kept for validation; what is missed most comes first.
/// @return indices of experiments, four at most
std::vector<std::size_t> experiments_on_page_one(const Results& results);

/// The loops of the first of them, over the whole width of the page.
/// @param height  of all of them together on paper (px)
std::string page_one_loops(const ReportData& data, std::size_t count, int height,
                           FigureSheet& figures);

}  // namespace pliant::report
