#include <fmt/format.h>

#include "pliant/io/base64.h"
#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

/// A picture of its own in the page, in which no part of it can run.
std::string picture(const WholeSheetData& whole) {
  if (whole.picture.empty()) return {};
  return fmt::format(
      "<figure><img alt=\"Silhouettes of {0}\" style=\"max-width: 100%\" "
      "src=\"data:image/svg+xml;base64,{1}\"></figure>\n",
      escape_html(whole.stated.name), base64(whole.picture));
}

std::string comparison(const ResultWholeSheet& stated) {
  const auto text = [&](const std::optional<double>& value) {
    return value ? fmt::format("{:.3g} {}", *value, stated.unit) : std::string();
  };
  return fact_list({{"measured, mean", text(stated.measured_mean)},
                    {"predicted", text(stated.predicted_mean)},
                    {"RMS error", text(stated.rms)},
                    {"rows", std::to_string(stated.points)}});
}

}  // namespace

std::string whole_sheet_section(const ReportData& data) {
  if (data.whole_sheets.empty()) return {};
  std::string html =
      "<section id=\"whole-sheets\"><h2>Whole sheets</h2>\n"
      "<p>All of a material shows in these tests together: they are predicted, and no fit learns "
      "from them.</p>\n";
  for (const WholeSheetData& whole : data.whole_sheets) {
    html += fmt::format("<h3>{}, {}</h3>\n", escape_html(whole.stated.name),
                        escape_html(whole.stated.type));
    html += comparison(whole.stated) + bullet_list(whole.stated.told) + picture(whole) +
            bullet_list(whole.stated.handled);
  }
  return html + "</section>\n";
}

}  // namespace pliant::report
