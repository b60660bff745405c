#include "pliant/report/preview.h"

#include <numeric>

#include <fmt/format.h>

#include "pliant/measurement/turning_points.h"
#include "pliant/report/html.h"
#include "pliant/report/page.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"
#include "pliant/report/thinning.h"

namespace pliant {
namespace report {
namespace {

constexpr std::size_t kMostSamples = 4000;  // drawn of a series
constexpr PrintSize kPrintSize{700, 400};

SeriesStyle outward() {
  SeriesStyle style = kMeasuredLoad;
  style.name = "on the way out";
  return style;
}

SeriesStyle backward() {
  SeriesStyle style = kMeasuredUnload;
  style.name = "on the way back";
  return style;
}

std::vector<double> at(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(values[row]);
  return result;
}

Figure loops(const Preview& preview) {
  std::vector<double> x[2], y[2];  // out, back
  for (const Preview::Series& series : preview.series) {
    const auto halves = half_cycles_of(series.driver, reversal_threshold(series.driver, 0));
    std::vector<std::size_t> turns;
    for (const HalfCycle& half : halves) turns.push_back(static_cast<std::size_t>(half.last));
    std::size_t next = 0;
    for (const std::size_t row : thin_for_drawing(series.measured, turns, kMostSamples)) {
      while (row > static_cast<std::size_t>(halves[next].last)) ++next;
      const int way = halves[next].direction == 1 ? 0 : 1;
      x[way].push_back(series.driver[row]);
      y[way].push_back(series.measured[row]);
    }
  }
  Figure figure;
  figure.layout = base_layout();
  figure.traces.push_back(trace(outward(), x[0], y[0]));
  if (!x[1].empty()) figure.traces.push_back(trace(backward(), x[1], y[1]));
  set_readable_axis(figure, 'x', preview.driver);
  set_readable_axis(figure, 'y', preview.measured);
  figure.description = fmt::format("{} over {}", preview.measured.name, preview.driver.name);
  figure.print_size = kPrintSize;
  return figure;
}

/// A quantity row by row, specimens one after the other.
Figure rows(const Preview& preview, const QuantityLabel& label,
            std::vector<double> Preview::Series::*values) {
  std::vector<double> all;
  for (const Preview::Series& series : preview.series) {
    all.insert(all.end(), (series.*values).begin(), (series.*values).end());
  }
  const std::vector<std::size_t> drawn = thin_for_drawing(all, {}, kMostSamples);
  std::vector<double> number(all.size());
  std::iota(number.begin(), number.end(), 1.0);
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis({"Row", ""});
  figure.traces.push_back(trace(kElastic, at(number, drawn), at(all, drawn)));
  set_readable_axis(figure, 'y', label);
  figure.description = label.name + " row by row";
  figure.print_size = kPrintSize;
  return figure;
}

}  // namespace
}  // namespace report

std::string preview_page(const Preview& preview) {
  using namespace report;
  FigureSheet figures = page_figures();
  std::string body = "<header>" + element("h1", preview.title) + "</header>\n";
  body += fact_list(preview.facts);
  body += "<section class=\"figure-block\"><h2>Readings</h2>\n";
  if (figures.can_draw()) body += legend_html(std::vector{outward(), backward()});
  body += figures.add(loops(preview), "figure-tall") + "</section>\n";
  body +=
      "<section class=\"figure-block\"><h2>Row by row</h2>\n" +
      figures.add(rows(preview, preview.driver, &Preview::Series::driver), "figure-medium") +
      figures.add(rows(preview, preview.measured, &Preview::Series::measured), "figure-medium") +
      "</section>\n";
  return page(preview.title, body, figures);
}

}  // namespace pliant
