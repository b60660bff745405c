#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pliant/experiment/textile_figure.h"
#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

std::string usual(const TextileFigure& kind) {
  if (kind.usual_most == 0) return {};
  return fmt::format("{} to {}", kind.usual_least, kind.usual_most);
}

/// As it is written by hand: `gf cm²/cm`, `µN m`.
std::string unit(const TextileFigure& kind) {
  if (kind.lab_unit == "1") return {};
  std::string text(kind.lab_unit);
  if (const std::size_t square = text.find("^2"); square != std::string::npos) {
    text.replace(square, 2, "²");
  }
  if (text.starts_with("uN")) text.replace(0, 1, "µ");
  return text;
}

std::string of_material(const ResultFigure& figure, const TextileFigure& kind) {
  const double value = kind.per_si * figure.value.value_or(NAN);
  const double error = kind.per_si * figure.std_error.value_or(0);
  const std::string mark = figure.beyond_range ? "*" : "";
  if (!(error > 0)) return format_significant(value, 3) + mark;
  const UncertainFormat format(value, error);
  return fmt::format("{} ± {}{}", format(value), format(error), mark);
}

std::string material_table(const Results& results) {
  HtmlTable table({{"Component"},
                   {"Standard"},
                   {"Figure"},
                   {"Material", Align::number},
                   {"Unit", Align::unit},
                   {"Usual of apparel fabrics", Align::number}},
                  "compact");
  int rows = 0;
  for (const ResultFigure& figure : results.figures) {
    const TextileFigure* kind = find_textile_figure(figure.name);
    if (!kind) continue;
    ++rows;
    table.begin_row();
    table.cell(component_title(figure.component));
    table.cell(std::string(kind->standard));
    table.cell(fmt::format("{}, {}", kind->symbol, kind->meaning));
    table.cell(of_material(figure, *kind));
    table.cell(unit(*kind));
    table.cell(usual(*kind));
  }
  return rows > 0 ? table.html() : std::string();
}

std::string loop_table(const Results& results) {
  HtmlTable table({{"Experiment"},
                   {"Standard"},
                   {"Figure"},
                   {"Measured", Align::number},
                   {"By the material", Align::number},
                   {"Unit", Align::unit}},
                  "compact");
  int rows = 0;
  for (const ResultExperiment& e : results.experiments) {
    for (const ResultLoopFigure& figure : e.figures) {
      const TextileFigure* kind = find_textile_figure(figure.name);
      if (!kind) continue;
      ++rows;
      table.begin_row();
      table.cell(e.name);
      table.cell(std::string(kind->standard));
      table.cell(fmt::format("{}, {}", kind->symbol, kind->meaning));
      table.cell(format_significant(figure.measured, 3));
      table.cell(format_significant(figure.predicted, 3));
      table.cell(unit(*kind));
    }
  }
  return rows > 0 ? table.html() : std::string();
}

}  // namespace

std::string standard_section(const ReportData& data) {
  const std::string material = material_table(data.results), loops = loop_table(data.results);
  if (material.empty() && loops.empty()) return {};
  std::string html =
      "<section id=\"standards\"><h2>Figures of textile laboratories</h2>\n"
      "<p>As the instruments of each standard read them, ± standard error; * by the law at strains "
      "that the data do not cover. <code>figures.csv</code> holds them all.</p>\n";
  html += material;
  if (!loops.empty()) {
    html +=
        "<h3>Of the measured loops</h3>\n<p>By the standard's recipe, from the measured loop and "
        "from that of the material; the standard's own speeds, pauses and loads may differ.</p>\n" +
        loops;
  }
  return html + "</section>\n";
}

}  // namespace pliant::report
