#pragma once

#include <cstddef>
#include <string>

#include "pliant/report/figure.h"
#include "pliant/report/report_data.h"

namespace pliant::report {

/// One full-field session, as a row of [T] Fig. 3.6: measured and predicted sheet, residuals,
/// forces or profiles. An `<article>`.
/// @param i  of the experiment
std::string sheet_part(const ReportData& data, std::size_t i, FigureSheet& figures);

/// All experiments of a study that has nothing but sessions.
std::string sheet_section(const ReportData& data, FigureSheet& figures);

}  // namespace pliant::report
