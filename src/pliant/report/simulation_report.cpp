#include "pliant/report/simulation_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/io/base64.h"
#include "pliant/report/energy_figure.h"
#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/page.h"

namespace pliant {
namespace report {
namespace {

using Align = HtmlTable::Align;

/// Three digits, and all of a whole number that has more.
std::string number_text(std::optional<double> number) {
  if (!number) return kNoValue;
  return std::abs(*number) < 1000 ? format_number(*number, 3) : fmt::format("{:.0f}", *number);
}

/// `38 ms`: in the unit that leaves the number between 1 and 1000.
std::string time_text(std::optional<double> seconds) {
  if (!seconds || *seconds == 0 || *seconds >= 1) return number_text(seconds) + " s";
  if (*seconds >= 1e-3) return number_text(1e3 * *seconds) + " ms";
  return number_text(1e6 * *seconds) + " µs";
}

std::string distance_text(std::optional<double> metres) {
  return metres ? number_text(1e3 * *metres) + " mm" : kNoValue;
}

std::string energy_text(double joules) {
  return std::abs(joules) < 0.1 ? number_text(1e3 * joules) + " mJ" : number_text(joules) + " J";
}

double simulated_time(const SimulationResults& results) {
  return results.finished ? results.last_time : results.steps * results.time_step;
}

std::string verdict(const SimulationResults& results) {
  std::string text = fmt::format("{} {} steps of {} for {} triangles",
                                 results.finished ? "Finished:" : "Not finished:", results.steps,
                                 time_text(results.time_step), results.triangles);
  text += results.seconds.median ? fmt::format(", {} of computing time a step (median).",
                                               time_text(results.seconds.median))
                                 : std::string(".");
  if (!results.finished) {
    text += fmt::format(" It stopped at {}; `pliant simulate --resume` goes on from there.",
                        time_text(simulated_time(results)));
  }
  const std::string limits = limits_text(results);
  return limits.empty() ? text : text + " " + limits;
}

std::string facts(const SimulationResults& results) {
  std::vector<std::pair<std::string, std::string>> all{
      {"Scene", std::filesystem::path(results.scene).filename().string()},
      {"Triangles", std::to_string(results.triangles)},
      {"Vertices", std::to_string(results.vertices)},
      {"Simulated time", time_text(simulated_time(results))},
      {"Steps", fmt::format("{} of {}", results.steps, time_text(results.time_step))},
      {"Frames", std::to_string(results.frames)}};
  const std::string method = method_text(results.method);
  if (!method.empty()) all.emplace_back("Method", method);
  if (results.seconds.mean) {
    all.emplace_back("Computing time", time_text(*results.seconds.mean * results.steps));
  }
  if (results.peak_memory) {
    all.emplace_back("Memory", number_text(results.peak_memory) + " MB");
  }
  if (results.min_contact_distance) {
    all.emplace_back("Least contact distance", distance_text(results.min_contact_distance));
  }
  all.insert(all.end(), results.info.begin(), results.info.end());
  return fact_list(all);
}

std::string energy_table(const std::vector<EnergySeries>& all) {
  HtmlTable table({{"Energy"}, {"At the end", Align::number}, {"Largest", Align::number}});
  for (const EnergySeries& series : all) {
    table.begin_row();
    table.cell(series.style.name);
    table.cell(energy_text(series.values.back()));
    table.cell(energy_text(*std::max_element(series.values.begin(), series.values.end())));
  }
  return table.html();
}

std::string energy_section(const SimulationResults& results, FigureSheet& figures) {
  if (results.energy.rows() < 2) return {};
  const EnergyFigure energy = energy_figure(results);
  std::string html = "<section class=\"figure-block\"><h2>Energy</h2>\n";
  if (figures.can_draw()) html += legend_html(energy.legend);
  return html + figures.add(energy.figure, "figure-medium") + energy_table(energy.series) +
         "<p class=\"small\">Stored energy and the sum less what they are at the first frame. The "
         "sum takes up the work of what is moved from outside, less what the time integrator "
         "damps.</p></section>\n";
}

std::string image(const std::string& png, const std::string& description) {
  return fmt::format("<img class=\"picture\" alt=\"{}\" src=\"data:image/png;base64,{}\">\n",
                     escape_html(description), base64(png));
}

std::string motion_section(const SimulationResults& results, const SimulationPictures& pictures) {
  std::string html;
  if (!pictures.motion.empty()) {
    html += image(pictures.motion, "Frames of " + results.name + " in the order of their times");
  }
  if (!pictures.missing.empty()) {
    html += "<p class=\"note\">" + escape_html(pictures.missing) + "</p>\n";
  }
  return html.empty() ? html : "<section><h2>Motion</h2>\n" + html + "</section>\n";
}

std::string field_section(const SimulationResults& results, const SimulationPictures& pictures) {
  if (pictures.fields.empty()) return {};
  std::string html = fmt::format(
      "<section id=\"fields\"><h2>Fields at {}</h2>\n<p>Means at each vertex of the triangles or "
      "hinges around it. The strain of bending is three times the curvature.</p>\n"
      "<div class=\"loops\">\n",
      time_text(results.last_time));
  for (const FieldPicture& field : pictures.fields) html += image(field.png, field.name);
  return html + "</div></section>\n";
}

std::string step_section(const SimulationResults& results) {
  HtmlTable table({{"Of a step"},
                   {"Smallest", Align::number},
                   {"Median", Align::number},
                   {"Mean", Align::number},
                   {"Largest", Align::number}});
  const auto row = [&](std::string_view name, const StepStatistics& numbers, auto text) {
    if (!numbers.median) return;
    table.begin_row();
    table.cell(name);
    for (const auto& number : {numbers.min, numbers.median, numbers.mean, numbers.max}) {
      table.cell(text(number));
    }
  };
  row("Computing time", results.seconds, time_text);
  for (const auto& [phase, seconds] : results.phases) row("– " + phase, seconds, time_text);
  if (results.substeps.max.value_or(1) > 1) {
    row("Parts that a step was taken in", results.substeps, number_text);
  }
  row("Newton iterations", results.newton_iterations, number_text);
  row("Iterations of the linear solver, all together", results.linear_iterations, number_text);
  row("Vertices and pairs that touch at its end", results.contacts, number_text);
  row("Least contact distance at its end", results.contact_distance, distance_text);
  row("Ways tested for what is met on them", results.way_tests, number_text);
  if (table.empty()) return {};
  return "<section id=\"steps\"><h2>Steps</h2>\n" + table.html() +
         "<p class=\"small\">A direct linear solver counts no iterations.</p></section>\n";
}

std::string origin_section(const SimulationResults& results) {
  const std::string facts =
      fact_table({{"Command", results.command},
                  {"Created", results.created},
                  {"Pliant version", results.version},
                  {"Scene", results.scene},
                  {"SHA-256 of the scene", results.scene_sha256},
                  {"Threads", results.threads > 0 ? std::to_string(results.threads) : ""}});
  return "<section id=\"origin\"><h2>Origin of these results</h2>\n" + facts +
         "<p>Beside this file: <code>simulation.json</code> (the facts above), "
         "<code>energy.csv</code> (a row a frame) and the frames themselves. "
         "<code>pliant render</code> draws them in any view and size.</p></section>\n";
}

}  // namespace
}  // namespace report

std::string make_simulation_report(const std::filesystem::path& results_directory,
                                   const SimulationPictures& pictures) {
  const report::SimulationResults results = report::read_simulation_results(results_directory);
  report::FigureSheet figures = report::page_figures();
  std::string body = "<section class=\"page-one\">\n<header><h1>";
  body += report::escape_html(results.name) + " <span>simulation</span></h1></header>\n";
  body +=
      fmt::format("<p class=\"verdict\">{}</p>\n", report::escape_html(report::verdict(results)));
  body += report::motion_section(results, pictures) + report::facts(results);
  body += report::energy_section(results, figures) + report::warning_section(results.warnings);
  body += "</section>\n" + report::step_section(results);
  body += report::field_section(results, pictures) + report::origin_section(results);
  return report::page(results.name + ": simulation", body, figures);
}

}  // namespace pliant
