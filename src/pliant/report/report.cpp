#include "pliant/report/report.h"

#include <string_view>

#include "pliant/report/embedded_bundle.h"
#include "pliant/report/html.h"
#include "pliant/report/report_data.h"
#include "pliant/report/sections.h"

namespace pliant {
namespace {

/// Forbids every request: a report is one file, and stays one even if a reader edits text into it.
constexpr std::string_view kSecurityPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:";

std::string head(const report::Results& results) {
  std::string html =
      "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"";
  html += kSecurityPolicy;
  html += "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += report::element("title",
                          results.name + (results.evaluation ? ": evaluation" : ": material fit"));
  html += "<style>\n";
  html += embedded_report_style();
  return html + "</style>\n";
}

}  // namespace

std::string make_report(const std::filesystem::path& results_directory) {
  const report::ReportData data = report::read_report_data(results_directory);
  const std::string_view script = embedded_report_script();
  report::FigureSheet figures(!script.empty());

  std::string body = report::summary_page(data, figures);
  body += report::experiment_section(data, figures);
  body += report::parameter_section(data.results);
  body += report::curve_section(data, figures);
  body += report::method_section(data.results);
  body += report::profile_section(data.results, figures);
  body += report::correlation_section(data.results);
  body += report::model_section(data.results);

  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n" + head(data.results) + "</head>\n";
  html += "<body>\n<main>\n" + body + "</main>\n" + figures.data_block();
  if (!script.empty()) {
    html += "<script>\n";
    html += script;
    html += "</script>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace pliant
