#pragma once

#include <string>

#include "pliant/report/figure.h"
#include "pliant/report/report_data.h"

/// The parts of a report in the order of the page, each as HTML. A part without content is empty.
namespace pliant::report {

/// Page one, for the person who signs: fits one printed page.
std::string summary_page(const ReportData& data, FigureSheet& figures);

/// Each experiment: loops, residuals, what was done with its data.
std::string experiment_section(const ReportData& data, FigureSheet& figures);

/// Tests that are only predicted: what a whole material shows.
std::string whole_sheet_section(const ReportData& data);

/// The estimated numbers with their uncertainty, nuisance parameters, singular values.
std::string parameter_section(const ReportData& data);

/// What the numbers of a heterogeneous material are at each of its samples.
std::string sample_section(const ReportData& data, FigureSheet& figures);

/// The figures of standards, of the material and of the measured loops, in the laboratory's units.
std::string standard_section(const ReportData& data);

/// Each component's stress-strain curve, the data under it, and its friction envelope.
std::string curve_section(const ReportData& data, FigureSheet& figures);

/// What was assumed, how the fit went, where the results come from.
std::string method_section(const Results& results);

/// Profile likelihoods.
std::string profile_section(const Results& results, FigureSheet& figures);

/// Correlations of the estimates.
std::string correlation_section(const Results& results);

/// Rival models by AIC and BIC.
std::string model_section(const Results& results);

}  // namespace pliant::report
