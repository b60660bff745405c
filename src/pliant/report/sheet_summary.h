#pragma once

#include <string>

#include "pliant/report/figure.h"
#include "pliant/report/report_data.h"

namespace pliant::report {

/// How well a material goes with full-field sessions, in a few sentences.
std::string sheet_verdict(const ReportData& data);

/// Page one of a study of full-field sessions, less what all studies have: what was measured, the
/// stiffness of each component, the residuals as [T] Tables A.1-A.4 give them, the search.
std::string sheet_findings(const ReportData& data, FigureSheet& figures);

/// The stiffness of each component at zero strain and at the largest of the data, with standard
/// errors; empty where nothing was fitted.
std::string stiffness_table(const ReportData& data);

/// The friction of each component that has any, and what was found of the cords; empty without
/// either.
std::string friction_table(const ReportData& data);

/// A row of [T] Tables A.1-A.4: the RMS residual of each session, in mm of free nodes where
/// positions are compared, else in N of clips.
std::string residual_table(const ReportData& data);

}  // namespace pliant::report
