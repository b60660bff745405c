#include "pliant/report/model_fits_report.h"

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/model_fits_figure.h"
#include "pliant/report/number_format.h"
#include "pliant/report/page.h"
#include "pliant/study/model_fits.h"

namespace pliant {
namespace report {
namespace {

using Align = HtmlTable::Align;
using Numbers = std::vector<std::optional<double>>;

constexpr PrintSize kFigureSize = {345, 150};

/// A column of numbers as text; the least is bold, with all that look like it.
std::vector<std::string> marked(const Numbers& numbers, int digits) {
  std::optional<double> least;
  for (const auto& number : numbers) {
    if (number && (!least || *number < *least)) least = number;
  }
  const std::string best = format_significant(least, digits);
  std::vector<std::string> cells;
  for (const auto& number : numbers) {
    const std::string text = format_significant(number, digits);
    cells.push_back(number && text == best ? "<strong>" + text + "</strong>" : text);
  }
  return cells;
}

Numbers column(const ModelComparison& comparison, std::size_t session) {
  Numbers numbers;
  for (const ComparedFit& row : comparison.fits) numbers.push_back(row.error(session));
  return numbers;
}

std::string model_cell(const ComparedFit& row) {
  const std::string title = escape_html(model_title(row.model));
  if (!row.failure.empty()) return title + " <em>failed</em>";
  const std::string link =
      fmt::format("<a href=\"{}/report.html\">{}</a>", escape_html(row.folder), title);
  return row.converged ? link : link + " <em>not converged</em>";
}

/// The rows in the form of [T] Tables A.1-A.4: a variant is named once, its models stand under it.
/// @param columns  of numbers as HTML, one cell a row
std::string table_html(const ModelComparison& comparison, std::vector<HtmlTable::Column> head,
                       const std::vector<std::vector<std::string>>& columns) {
  head.insert(head.begin(), {{"Variant"}, {"Model"}});
  HtmlTable table(std::move(head), "compact model-fits");
  std::string variant;
  for (std::size_t r = 0; r < comparison.fits.size(); ++r) {
    const ComparedFit& row = comparison.fits[r];
    const bool again = r > 0 && row.variant == variant;
    variant = row.variant;
    table.begin_row(again ? "" : "first-of-group");
    table.cell(again ? "" : variant_title(variant));
    table.html_cell(model_cell(row));
    for (const auto& cells : columns) table.html_cell(cells[r]);
  }
  return table.html();
}

/// The sessions of a role, with the numbers that belong to a fit as a whole beside the fitted ones.
std::string session_table(const ModelComparison& comparison, bool validation) {
  std::vector<HtmlTable::Column> head;
  std::vector<std::vector<std::string>> columns;
  for (std::size_t s = 0; s < comparison.sessions.size(); ++s) {
    const ComparedSession& session = comparison.sessions[s];
    if (session.validation != validation) continue;
    head.push_back({session.name, Align::number, session.unit});
    columns.push_back(marked(column(comparison, s), 3));
  }
  if (head.empty()) return {};
  if (!validation) {
    Numbers misfits;
    std::vector<std::string> parameters, seconds;
    for (const ComparedFit& row : comparison.fits) {
      misfits.push_back(row.misfit);
      parameters.push_back(row.parameters ? std::to_string(*row.parameters) : kNoValue);
      seconds.push_back(format_significant(row.seconds, 2));
    }
    head.insert(head.end(), {{"Misfit", Align::number, "%"},
                             {"Parameters", Align::number},
                             {"Time", Align::number, "s"}});
    columns.insert(columns.end(), {marked(misfits, 3), parameters, seconds});
  }
  return table_html(comparison, std::move(head), columns);
}

std::string tables(const ModelComparison& comparison) {
  const std::string fitted = session_table(comparison, false),
                    predicted = session_table(comparison, true);
  std::string html;
  if (!fitted.empty()) {
    html += "<section><h2>Fitted sessions: RMS errors</h2>\n" + fitted +
            "<p class=\"small\">Errors in N are of the forces of clips (of shear: along the "
            "clips), in mm of the positions of all free nodes. The least of a column is bold. "
            "Misfit: root mean square of the errors, each in per cent of the session's largest "
            "force or of the sheet's longer side; it is what the fits are compared by. The name "
            "of a model leads to the report of its fit.</p></section>\n";
  }
  if (!predicted.empty()) {
    html +=
        "<section><h2>Sessions that were not fitted: RMS errors</h2>\n" + predicted +
        "<p class=\"small\">Predicted with the material of each fit. More parameters always follow "
        "the fitted sessions at least as well; these sessions say whether they know the cloth "
        "better.</p></section>\n";
  }
  return html;
}

std::string failures(const ModelComparison& comparison) {
  std::vector<std::string> lines;
  for (const ComparedFit& row : comparison.fits) {
    if (!row.failure.empty()) lines.push_back(fit_title(row) + ": " + row.failure);
  }
  if (lines.empty()) return {};
  return "<section class=\"warnings\"><h2>Fits that failed</h2>\n" + bullet_list(lines) +
         "</section>\n";
}

std::string charts(const ModelComparison& comparison, FigureSheet& figures) {
  if (comparison.sessions.empty()) return {};
  std::string html = "<section class=\"figure-block\"><h2>Each session</h2>\n";
  if (figures.can_draw()) html += legend_html(model_styles(comparison));
  html += "<div class=\"pair\">\n";
  for (std::size_t s = 0; s < comparison.sessions.size(); ++s) {
    Figure figure = model_fits_figure(comparison, s);
    figure.print_size = kFigureSize;
    html += fmt::format("<figure><figcaption><strong>{}</strong> {}</figcaption>\n{}</figure>\n",
                        escape_html(comparison.sessions[s].name),
                        comparison.sessions[s].validation ? "not fitted" : "fitted",
                        figures.add(figure, "figure-short"));
  }
  return html + "</div></section>\n";
}

/// What the names in the table mean, for readers who have not seen any of them.
constexpr std::string_view kGlossary =
    "<section><h2>What was compared</h2>\n"
    "<p>A <em>model</em> says how strain of the cloth is measured. <em>Soft constraints</em>: how "
    "much longer warp and weft are than at rest, and the angle between them. <em>St. "
    "Venant-Kirchhoff</em>: Green-Lagrange strain, half of (stretch&sup2; &minus; 1). "
    "<em>Springs</em>: the lengths of springs along the lines of a grid, its diagonals, and from "
    "each node to the next but one, which resist bending.</p>\n"
    "<p>A <em>variant</em> says how much freedom the stiffnesses have. <em>Nonlinear</em>: they "
    "are curves over strain; <em>linear</em>: numbers. <em>Orthotropic</em>: weft and warp have "
    "their own; <em>isotropic</em>: they share them. All fits take the same sessions, the same "
    "meshes and the same search.</p></section>\n";

std::string origin(const ModelFits& fits) {
  const std::string facts = fact_table({{"Command", fits.facts.command},
                                        {"Created", fits.facts.created},
                                        {"Pliant version", fits.facts.version},
                                        {"Study", fits.facts.study},
                                        {"SHA-256 of the study", fits.facts.study_sha256}});
  return "<section id=\"origin\"><h2>Origin of these results</h2>\n" + facts +
         "<p>Beside this file: <code>summary.csv</code> and <code>summary.json</code> (the tables "
         "above), and a folder with all results of each fit.</p></section>\n";
}

}  // namespace
}  // namespace report

std::string make_model_fits_report(const std::filesystem::path& results_directory) {
  const ModelFits fits = read_model_fits(results_directory);
  report::FigureSheet figures = report::page_figures();
  std::string body = "<header><h1>" + report::escape_html(fits.name) +
                     " <span>comparison of cloth models</span></h1></header>\n";
  body += fmt::format("<p class=\"verdict\">{}</p>\n", report::escape_html(fits.verdict));
  body += report::tables(fits.comparison) + report::failures(fits.comparison);
  body += report::charts(fits.comparison, figures);
  body += std::string(report::kGlossary) + report::origin(fits);
  return report::page(fits.name + ": comparison of cloth models", body, figures);
}

}  // namespace pliant
