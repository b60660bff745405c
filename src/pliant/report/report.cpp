#include "pliant/report/report.h"

#include "pliant/report/page.h"
#include "pliant/report/report_data.h"
#include "pliant/report/sections.h"

namespace pliant {

std::string make_report(const std::filesystem::path& results_directory) {
  const report::ReportData data = report::read_report_data(results_directory);
  report::FigureSheet figures = report::page_figures();
  std::string body = report::summary_page(data, figures);
  body += report::experiment_section(data, figures);
  body += report::whole_sheet_section(data);
  body += report::parameter_section(data);
  body += report::sample_section(data, figures);
  body += report::standard_section(data);
  body += report::curve_section(data, figures);
  body += report::method_section(data.results);
  body += report::profile_section(data.results, figures);
  body += report::correlation_section(data.results);
  body += report::model_section(data.results);
  const char* kind = data.results.evaluation ? ": evaluation" : ": material fit";
  return report::page(data.results.name + kind, body, figures);
}

}  // namespace pliant
