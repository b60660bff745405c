#include "pliant/report/simulation_report.h"

#include <algorithm>
#include <cmath>
#include <map>
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

double simulated_time(const SimulationResult& result) {
  return result.finished ? result.last_time() : result.steps * result.time_step;
}

std::string verdict(const SimulationResult& result) {
  std::string text = fmt::format("{} {} steps of {} for {} triangles",
                                 result.finished ? "Finished:" : "Not finished:", result.steps,
                                 time_text(result.time_step), result.triangles);
  text += result.seconds.median ? fmt::format(", {} of computing time a step (median).",
                                              time_text(result.seconds.median))
                                : std::string(".");
  if (!result.finished) {
    text += fmt::format(" It stopped at {}; `pliant simulate --resume` goes on from there.",
                        time_text(simulated_time(result)));
  }
  const std::string limits = limits_text(result);
  return limits.empty() ? text : text + " " + limits;
}

std::string facts(const SimulationResult& result) {
  std::vector<std::pair<std::string, std::string>> all{
      {"Scene", std::filesystem::path(result.scene).filename().string()},
      {"Triangles", std::to_string(result.triangles)},
      {"Vertices", std::to_string(result.vertices)},
      {"Simulated time", time_text(simulated_time(result))},
      {"Steps", fmt::format("{} of {}", result.steps, time_text(result.time_step))},
      {"Frames", std::to_string(result.frame_times.size())}};
  const std::string method = method_text(result.method);
  if (!method.empty()) all.emplace_back("Method", method);
  if (result.seconds.mean) {
    all.emplace_back("Computing time", time_text(*result.seconds.mean * result.steps));
  }
  if (result.facts.peak_memory) {
    all.emplace_back("Memory", number_text(result.facts.peak_memory) + " MB");
  }
  if (result.min_contact_distance) {
    all.emplace_back("Least contact distance", distance_text(result.min_contact_distance));
  }
  all.insert(all.end(), result.info.begin(), result.info.end());
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

std::string energy_section(const SimulationResult& result, const std::vector<EnergyRow>& rows,
                           FigureSheet& figures) {
  if (rows.size() < 2) return {};
  const EnergyFigure energy = energy_figure(result, rows);
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

std::string motion_section(const SimulationResult& result, const SimulationPictures& pictures) {
  std::string html;
  if (!pictures.motion.empty()) {
    html += image(pictures.motion, "Frames of " + result.name + " in the order of their times");
  }
  if (!pictures.missing.empty()) {
    html += "<p class=\"note\">" + escape_html(pictures.missing) + "</p>\n";
  }
  return html.empty() ? html : "<section><h2>Motion</h2>\n" + html + "</section>\n";
}

std::string field_section(const SimulationResult& result, const SimulationPictures& pictures) {
  if (pictures.fields.empty()) return {};
  std::string html = fmt::format(
      "<section id=\"fields\"><h2>Fields at {}</h2>\n<p>Means at each vertex of the triangles or "
      "hinges around it. The strain of bending is three times the curvature.</p>\n"
      "<div class=\"loops\">\n",
      time_text(result.last_time()));
  for (const FieldPicture& field : pictures.fields) html += image(field.png, field.name);
  return html + "</div></section>\n";
}

/// What the time of a step goes to, in words.
std::string_view words_for(const std::string& phase) {
  static const std::map<std::string, std::string_view> words{
      {"assembly", "forces and Hessians"},       {"equations", "linear equations"},
      {"energies", "energies along the search"}, {"pairs", "search for what is near"},
      {"ways", "how far vertices may go"},       {"history", "what is remembered of it"}};
  return words.at(phase);
}

std::string step_section(const SimulationResult& result) {
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
  row("Computing time", result.seconds, time_text);
  for (const auto& [phase, seconds] : result.phases) {
    row(fmt::format("– {}", words_for(phase)), seconds, time_text);
  }
  if (result.substeps.max.value_or(1) > 1) {
    row("Parts that a step was taken in", result.substeps, number_text);
  }
  row("Newton iterations", result.newton_iterations, number_text);
  row("Iterations of the linear solver, all together", result.linear_iterations, number_text);
  row("Vertices and pairs that touch at its end", result.contacts, number_text);
  row("Least contact distance at its end", result.contact_distance, distance_text);
  row("Ways tested for what is met on them", result.way_tests, number_text);
  if (table.empty()) return {};
  return "<section id=\"steps\"><h2>Steps</h2>\n" + table.html() +
         "<p class=\"small\">A direct linear solver counts no iterations.</p></section>\n";
}

std::string origin_section(const SimulationResult& result) {
  const std::string facts = fact_table(
      {{"Command", result.facts.command},
       {"Created", result.facts.created},
       {"Pliant version", result.facts.version},
       {"Scene", result.scene},
       {"SHA-256 of the scene", result.facts.scene_sha256},
       {"Threads", result.facts.threads > 0 ? std::to_string(result.facts.threads) : ""}});
  return "<section id=\"origin\"><h2>Origin of these results</h2>\n" + facts +
         "<p>Beside this file: <code>simulation.json</code> (the facts above), "
         "<code>energy.csv</code> (a row a frame) and the frames themselves. "
         "<code>pliant render</code> draws them in any view and size.</p></section>\n";
}

}  // namespace
}  // namespace report

std::string make_simulation_report(const std::filesystem::path& results_directory,
                                   const SimulationPictures& pictures) {
  const SimulationResult result = read_simulation_result(results_directory);
  std::vector<EnergyRow> energies;
  if (!result.energy.empty()) energies = read_energy_table(results_directory / result.energy);
  report::FigureSheet figures = report::page_figures();
  std::string body = "<section class=\"page-one\">\n<header><h1>";
  body += report::escape_html(result.name) + " <span>simulation</span></h1></header>\n";
  body +=
      fmt::format("<p class=\"verdict\">{}</p>\n", report::escape_html(report::verdict(result)));
  body += report::motion_section(result, pictures) + report::facts(result);
  body +=
      report::energy_section(result, energies, figures) + report::warning_section(result.warnings);
  body += "</section>\n" + report::step_section(result);
  body += report::field_section(result, pictures) + report::origin_section(result);
  return report::page(result.name + ": simulation", body, figures);
}

}  // namespace pliant
