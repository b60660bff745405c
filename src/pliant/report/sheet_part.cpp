#include "pliant/report/sheet_part.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sheet_figures.h"
#include "pliant/report/sheet_picture.h"
#include "pliant/report/sheet_view.h"

namespace pliant::report {
namespace {

constexpr PrintSize kFigureSize = {345, 276};

/// Frames of each three-dimensional view, so that a page stays light: a node of a frame takes 16
/// characters in it.
int view_frames(const ReportData& data) {
  constexpr int kMost = 40, kFewest = 6;
  constexpr long kCharacters = 2'400'000, kEach = 16;
  long nodes = 0;
  for (const auto& sheet : data.sheets) {
    if (sheet) nodes += sheet->session.measured.rest.vertex_count();
  }
  const long frames = kCharacters / (kEach * std::max(nodes, 1L));
  return static_cast<int>(std::clamp<long>(frames, kFewest, kMost));
}

std::string description(const ResultExperiment& e, const SheetData& sheet, bool evaluation) {
  std::vector<std::string> facts;
  if (e.direction != e.name && !e.direction.empty()) facts.push_back(e.direction);
  facts.push_back(evaluation || e.validation ? "predicted, not fitted" : "fitted");
  const bool seen = sheet.session.is_seen();
  facts.push_back(fmt::format("{} {}", sheet.session.frame_count(), seen ? "frames" : "rows"));
  if (sheet.rms_clip_force) {
    facts.push_back((seen ? "RMS error of the clips' forces " : "RMS error of the force ") +
                    format_significant(sheet.rms_clip_force, 2) + " N" +
                    (e.peak_force ? fmt::format(", largest {}{} N", seen ? "component " : "",
                                                format_significant(e.peak_force, 3))
                                  : std::string()));
  }
  if (sheet.rms_distance) {
    facts.push_back("RMS distance of all free nodes " +
                    format_significant(1e3 * *sheet.rms_distance, 2) + " mm");
  }
  if (e.fold_height_error_mm) {
    facts.push_back("RMS error of the height of folds, wherever they are, " +
                    format_significant(e.fold_height_error_mm, 2) + " mm");
  }
  return fmt::format("{}", fmt::join(facts, " · "));
}

std::string captioned(std::string_view caption, const std::string& figure) {
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption, figure);
}

std::string view(const ReportData& data, const ResultExperiment& e, const SheetSession& session,
                 int frame, FigureSheet& figures) {
  const double largest = largest_residual(session);
  const std::string caption = fmt::format(
      "Measured and predicted sheet{}, coloured by the position residual: light none, dark {} mm. "
      "On "
      "paper frame {}, the most distorted one.",
      session.measured.clips.empty() ? "" : " with the forces of the clips",
      format_significant(1e3 * largest, 2), frame + 1);
  return captioned(caption, figures.add_view(sheet_view(session, view_frames(data)),
                                             "Measured and predicted sheet of " + e.name,
                                             sheet_picture(session, frame, largest)));
}

std::string residuals(const SheetSession& session, int frame) {
  return captioned(
      fmt::format(
          "Position residual of frame {}, predicted less measured, {:g} times as long: {} mm "
          "(RMS of free nodes)",
          frame + 1, kResidualMagnification,
          format_significant(1e3 * rms_distance(session, frame), 2)),
      residual_picture(session, frame));
}

std::string graph(const ResultExperiment& e, const SheetSession& session, FigureSheet& figures) {
  Figure figure = sheet_figure(session, /*compact=*/false);
  figure.data_file = e.sheet_folder;
  figure.print_size = kFigureSize;
  const bool bends = session.measured.clips.empty();
  const std::string_view caption = bends ? "The middle of the sheet from the side, in some frames"
                                         : "Force against displacement";
  return captioned(caption, figures.add(figure, "figure-tall"));
}

/// What stands with the heading on paper, and what may follow on the next page.
struct SheetFigures {
  std::string first, rest;
};

/// The figures of a sheet whose vertices were seen.
SheetFigures seen_sheet(const ReportData& data, const ResultExperiment& e,
                        const SheetSession& session, FigureSheet& figures) {
  const int frame = most_distorted_frame(session.measured);
  SheetFigures html{view(data, e, session, frame, figures), "<div class=\"together\">\n"};
  if (figures.can_draw()) html.rest += legend_html(std::vector{kMeasuredSheet, kPredictedSheet});
  html.rest += "<div class=\"pair\">\n" + graph(e, session, figures) + residuals(session, frame) +
               "</div></div>\n";
  return html;
}

/// Those of a strip, of which a tester saw force and extension alone.
SheetFigures strip(const ResultExperiment& e, const SheetSession& session, FigureSheet& figures) {
  SheetFigures html{graph(e, session, figures), ""};
  if (figures.can_draw()) html.first += legend_html(std::vector{kMeasuredSheet, kPredictedSheet});
  return html;
}

/// Why measured forces go a loop, and whether the predicted ones can.
std::string about_loops(const Results& results, bool strips) {
  const bool cloth = std::ranges::any_of(results.parameters, [](const ResultParameter& p) {
    return p.name.find(".friction.") != std::string::npos;
  });
  const bool cords = std::ranges::any_of(results.nuisance, [](const ResultParameter& p) {
    return p.name.ends_with(".cord_friction");
  });
  std::string text = strips ? "Measured forces go a loop, for cloth rubs. "
                            : "Measured forces go a loop, for cloth and cords rub. ";
  if (cloth && cords) {
    text += "The prediction goes a loop, too, by the friction of the cloth and of the cords. ";
  } else if (cloth) {
    text += "The prediction goes a loop, too, by the friction of the cloth. ";
  } else if (cords) {
    text += "The prediction goes a loop, too, by the friction of the cords. ";
  } else {
    text += "An elastic material passes through its middle. ";
  }
  return text + fmt::format(
                    "Residuals that change from {0} to {0} are what the material cannot "
                    "follow.",
                    strips ? "row" : "frame");
}

}  // namespace

std::string sheet_part(const ReportData& data, std::size_t i, FigureSheet& figures) {
  const ResultExperiment& e = data.results.experiments[i];
  const SheetData& sheet = *data.sheets[i];
  std::string html = "<article class=\"figure-block\">\n<div class=\"together\">\n<h3>" +
                     escape_html(e.name) + "</h3>\n";
  html += fmt::format("<p class=\"description\">{}</p>\n",
                      escape_html(description(e, sheet, data.results.evaluation)));
  const auto [first, rest] = sheet.session.is_seen() ? seen_sheet(data, e, sheet.session, figures)
                                                     : strip(e, sheet.session, figures);
  html += first + "</div>\n" + rest;
  if (!e.handled.empty()) {
    html += "<h4>What was done with its data</h4>\n" + bullet_list(e.handled);
  }
  return html + "</article>\n";
}

std::string sheet_section(const ReportData& data, FigureSheet& figures) {
  std::string html = fmt::format("<section id=\"experiments\"><h2>{}</h2>\n<p>{}</p>\n",
                                 data.is_of_strips() ? "Strips" : "Sessions",
                                 about_loops(data.results, data.is_of_strips()));
  if (figures.can_draw() && !data.is_of_strips()) {
    html += "<p>Drag a sheet to turn both, hold Ctrl and roll the wheel to come nearer.</p>\n";
  }
  for (std::size_t i = 0; i < data.sheets.size(); ++i) html += sheet_part(data, i, figures);
  return html + "</section>\n";
}

}  // namespace pliant::report
