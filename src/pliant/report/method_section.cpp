#include <algorithm>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"
#include "pliant/report/page_budget.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

std::string assumptions(const Results& results) {
  if (results.assumptions.empty()) return {};
  return "<h3>What was assumed</h3>\n" + bullet_list(results.assumptions);
}

std::string more_warnings(const Results& results) {
  const std::vector<std::string> others = warnings_of(results, /*on_page_one=*/false);
  return others.empty() ? std::string() : "<h3>More warnings</h3>\n" + bullet_list(others);
}

std::string starts(const Results& results) {
  std::vector<std::string> lines;
  for (const StartRecord& start : results.starts) {
    std::vector<std::string> ends;
    for (const double end : start.ends) ends.push_back(format_significant(end, 3));
    const std::string what =
        start.followed ? fmt::format("{}: {} of {} starts reached the same best fit",
                                     start.component, start.reached_best, start.ends.size())
                       : fmt::format("{}, {}: the best of {} starts was followed", start.component,
                                     start.search, start.ends.size());
    lines.push_back(what + (ends.empty() ? ""
                                         : fmt::format(" (RMS {}, {}: {})",
                                                       start.followed ? "there" : "as they begin",
                                                       start.unit, fmt::join(ends, ", "))));
  }
  if (lines.empty()) return {};
  return "<h3>Starts</h3>\n<p>Searches of strips are started from several points; where only one "
         "of "
         "many reaches the best fit, a better one may exist. Searches of sheets take long: their "
         "starts are compared where they begin, and the best alone is followed.</p>\n" +
         bullet_list(lines);
}

std::string stages(const Results& results) {
  if (results.stages.empty()) return {};
  HtmlTable table({{"Component"},
                   {"Stage"},
                   {"RMS error", Align::number},
                   {"Unit"},
                   {"Kept"},
                   {"Growth ended"}});
  for (const FitStage& stage : results.stages) {
    table.begin_row();
    table.cell(stage.component);
    table.cell(stage.name);
    table.cell(format_significant(stage.rms, 3));
    table.cell(shown_unit(stage.unit));
    table.cell(stage.accepted ? "yes" : "no");
    table.cell(stage.ended);
  }
  return "<h3>Stages</h3>\n" + table.html();
}

/// Equilibria, derivatives and the rest: seconds, and what was done in them.
std::string work(const Results& results) {
  if (!results.work) return {};
  const EquilibriumCounts& counts = results.work->counts;
  const EquilibriumSeconds& seconds = results.work->seconds;
  const double found = seconds.search + seconds.derivatives;
  const double all = std::max(results.seconds.value_or(0), found);
  HtmlTable table({{"Work"}, {"Time", Align::number, "s"}, {"Share", Align::number}, {"Of it"}});
  const auto row = [&](std::string_view name, double spent, const std::string& what) {
    table.begin_row();
    table.cell(name);
    table.cell(format_significant(spent, 3));
    table.cell(all > 0 ? format_percent(100 * spent / all) : kNoValue);
    table.cell(what);
  };
  row("Equilibria", seconds.search,
      fmt::format("{} in {} iterations of Newton's method", counts.equilibria, counts.iterations));
  row("Derivatives", seconds.derivatives,
      fmt::format("of {} equilibria by all parameters that were searched for",
                  counts.differentiated));
  row("The rest", all - found, "least squares, meshes, reading");
  std::string html =
      "<h3>Where the time went</h3>\n"
      "<p>The sheet of each frame is brought into equilibrium for each material that is tried, "
      "and how it would change with the material follows from the same equations: "
      "derivatives need no further equilibrium.";
  if (counts.equilibria > 0 && counts.differentiated > 0) {
    const int by_differences = counts.equilibria + counts.differences;
    html += fmt::format(
        " Forward differences would have needed {} equilibria instead of {}, {} times as many.",
        by_differences, counts.equilibria,
        format_significant(static_cast<double>(by_differences) / counts.equilibria, 2));
  }
  return html + fmt::format(" {} Hessians were factorised.</p>\n", counts.factors) + table.html();
}

std::string data_files(const Results& results) {
  if (results.data.empty()) return {};
  HtmlTable table({{"Experiment"}, {"File"}, {"SHA-256"}});
  for (const DataFile& d : results.data) {
    table.begin_row();
    for (const std::string* cell : {&d.experiment, &d.file, &d.sha256}) table.cell(*cell);
  }
  return "<h3>Data</h3>\n" + table.html();
}

std::string provenance(const Results& results) {
  std::vector<std::pair<std::string, std::string>> facts{{"Command", results.facts.command},
                                                         {"Created", results.facts.created},
                                                         {"Pliant version", results.facts.version},
                                                         {"Estimator", results.estimator}};
  if (results.seconds) {
    facts.emplace_back("Computing time", format_significant(results.seconds, 2) + " s");
  }
  facts.insert(facts.end(), results.conditions.begin(), results.conditions.end());
  facts.insert(facts.end(), results.info.begin(), results.info.end());
  return "<h3>Origin of these results</h3>\n" + fact_table(facts) +
         "<p>Beside this file: <code>material.json</code> (the material), "
         "<code>parameters.csv</code>, <code>figures.csv</code>, <code>curves.csv</code>, "
         "<code>predictions/</code> (each "
         "experiment row by row) and <code>study.resolved.yaml</code> (the study with every "
         "default "
         "filled in).</p>\n";
}

}  // namespace

std::string method_section(const Results& results) {
  return "<section id=\"method\"><h2>Assumptions and method</h2>\n" + assumptions(results) +
         more_warnings(results) + stages(results) + starts(results) + work(results) +
         data_files(results) + provenance(results) + "</section>\n";
}

}  // namespace pliant::report
