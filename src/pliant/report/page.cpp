#include "pliant/report/page.h"

#include <string_view>

#include "pliant/report/embedded_bundle.h"
#include "pliant/report/html.h"

namespace pliant::report {
namespace {

/// Forbids every request: a report is one file, and stays one even if a reader edits text into it.
constexpr std::string_view kSecurityPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:";

std::string head(const std::string& title) {
  std::string html =
      "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"";
  html += kSecurityPolicy;
  html += "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += element("title", title);
  html += "<style>\n";
  html += embedded_report_style();
  return html + "</style>\n";
}

std::string script_element(std::string_view script) {
  if (script.empty()) return {};
  std::string html = "<script>\n";
  html += script;
  return html + "</script>\n";
}

}  // namespace

FigureSheet page_figures() { return FigureSheet(!embedded_report_script().empty()); }

std::string page(const std::string& title, const std::string& body, const FigureSheet& figures) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n" + head(title) + "</head>\n";
  html += "<body>\n<main>\n" + body + "</main>\n" + figures.data_block();
  html += script_element(embedded_report_script());
  if (figures.has_views()) html += script_element(embedded_sheet_script());
  return html + "</body>\n</html>\n";
}

}  // namespace pliant::report
