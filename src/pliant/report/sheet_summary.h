#pragma once

#include <string>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/report_data.h"

namespace pliant::report {

/// Tables of page one of a study of full-field sessions beside that of the material: stiffness of
/// what has no figures of a laboratory, friction, the residuals as [T] Tables A.1-A.4 give them.
/// Those that are not empty.
std::vector<std::string> sheet_tables(const ReportData& data);

/// How the search went, in a line.
std::string sheet_search(const Results& results);

/// The stiffness of each component without figures of a laboratory, as the hinges of a mesh, at
/// zero strain and at the largest of the data, with standard errors; empty where nothing was
/// fitted.
std::string stiffness_table(const ReportData& data);

/// The friction of each component that has any, and what was found of the cords; empty without
/// either.
std::string friction_table(const ReportData& data);

/// A row of [T] Tables A.1-A.4: the RMS residual of each session, in mm of free nodes where
/// positions are compared, else in N of clips.
std::string residual_table(const ReportData& data);

}  // namespace pliant::report
