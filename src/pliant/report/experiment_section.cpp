#include <algorithm>

#include <fmt/format.h>

#include "pliant/experiment/registry.h"
#include "pliant/report/html.h"
#include "pliant/report/loop_figure.h"
#include "pliant/report/number_format.h"
#include "pliant/report/readable_unit.h"
#include "pliant/report/residual_figure.h"
#include "pliant/report/sections.h"
#include "pliant/report/shape_part.h"
#include "pliant/report/sheet_part.h"

namespace pliant::report {
namespace {

constexpr PrintSize kLoopSize = {345, 276};
constexpr PrintSize kResidualSize = {345, 130};

/// Rows drawn of one experiment, so that a report on many stays light.
std::size_t row_budget(std::size_t experiments) {
  constexpr std::size_t kAllExperiments = 30'000;
  constexpr std::size_t kMost = 800;
  constexpr std::size_t kFewest = 150;
  return std::clamp(kAllExperiments / std::max<std::size_t>(experiments, 1), kFewest, kMost);
}

std::string_view reference_of(const ResultExperiment& e) {
  if (e.measures_overhangs()) return "mean overhang";
  if (e.measures_readings()) return "the largest reading";
  if (e.measures_lengths()) return "range of the lengths";
  return facts_of_test(e.type).has_unknown_zero ? "the span of the force" : "peak";
}

/// `0.024 of 1.97 N`, in the unit of the figures.
std::string force_in_words(const ResultExperiment& e) {
  const std::string own = quantity_label(e.quantity).unit;
  const ReadableUnit unit = readable_unit(own == "N/m" ? own : "N", *e.peak_force);
  return fmt::format("{} of {} {}", format_significant(unit.factor * *e.rms_force, 2),
                     format_significant(unit.factor * *e.peak_force, 3), unit.name);
}

/// `RMS error 1.2 % of peak (0.024 of 1.97 N)`
std::string error_in_words(const ResultExperiment& e) {
  std::string detail;
  if (e.rms_position_mm) detail = format_significant(e.rms_position_mm, 2) + " mm";
  if (e.rms_percent_of_length) {
    return fmt::format("RMS distance {} ({} of the strip's length)", detail,
                       format_percent(e.rms_percent_of_length));
  }
  if (e.rms_force && e.peak_force) detail = force_in_words(e);
  if (!e.rms_percent_of_peak) return detail.empty() ? detail : "RMS error " + detail;
  return fmt::format("RMS error {} of {}{}", format_percent(e.rms_percent_of_peak), reference_of(e),
                     detail.empty() ? detail : " (" + detail + ")");
}

/// `force: 12 mN, stated; neighbouring rows scatter by 15 mN`
std::string noise_in_words(const ResultNoise& noise) {
  const auto in_words = [&](double value) {
    const ReadableUnit unit = readable_unit(noise.unit, value);
    return format_significant(unit.factor * value, 2) + " " + unit.name;
  };
  std::string text = fmt::format("{}: {}{}", noise.quantity, in_words(noise.value),
                                 noise.source.empty() ? "" : ", " + noise.source);
  if (noise.floor) text += "; neighbouring rows scatter by " + in_words(*noise.floor);
  return text;
}

/// What was tested and how well it came out, one phrase a fact.
std::string description(const ResultExperiment& e, std::optional<MembraneMeasure> membrane,
                        bool evaluation) {
  std::vector<std::string> facts;
  if (!e.type.empty()) facts.push_back(e.type);
  if (!e.direction.empty()) facts.push_back(e.direction);
  facts.push_back(evaluation || e.validation ? "predicted, not fitted" : "fitted");
  facts.push_back(fmt::format("{} specimen{}", e.specimens, e.specimens == 1 ? "" : "s"));
  facts.push_back(fmt::format("{} points used, {} left out", e.points, e.excluded));
  if (e.strain_range) {
    facts.push_back(
        strain_range_text(e.component, membrane, (*e.strain_range)[0], (*e.strain_range)[1]));
  }
  const std::string error = error_in_words(e);
  if (!error.empty()) facts.push_back(error);
  if (e.rms_elastic_percent_of_peak) {
    facts.push_back("best curve without friction " + format_percent(e.rms_elastic_percent_of_peak));
  }
  if (e.rms_limp_percent_of_peak) {
    facts.push_back("a strip without any stiffness " + format_percent(e.rms_limp_percent_of_peak));
  }
  if (!e.rms_elastic_percent_of_peak && e.rms_elastic_position_mm) {
    facts.push_back("best curve without friction " +
                    format_significant(e.rms_elastic_position_mm, 2) + " mm");
  }
  if (e.noise && !e.validation) facts.push_back("noise of the " + noise_in_words(*e.noise));
  return fmt::format("{}", fmt::join(facts, " · "));
}

std::string captioned(std::string_view caption, const std::string& figure) {
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption, figure);
}

std::string residuals(const ResultExperiment& e, const Prediction& prediction, std::size_t budget,
                      std::optional<MembraneMeasure> membrane, FigureSheet& figures) {
  std::string html;
  for (const ResidualAbscissa abscissa : {ResidualAbscissa::strain, ResidualAbscissa::time}) {
    // Overhangs at one angle all belong to the same strain.
    if (abscissa == ResidualAbscissa::strain && (e.measures_overhangs() || e.measures_readings())) {
      continue;
    }
    Figure figure = residual_figure(e, prediction, abscissa, membrane, budget);
    figure.print_size = kResidualSize;
    const std::string order = prediction.time.empty() ? "in the order measured" : "against time";
    const std::string abscissa_name = abscissa == ResidualAbscissa::strain
                                          ? "against " + strain_name(e.component, membrane)
                                          : order;
    html +=
        captioned("Measured minus material, " + abscissa_name, figures.add(figure, "figure-short"));
  }
  return html;
}

std::string handled(const ResultExperiment& e) {
  if (e.handled.empty()) return {};
  return "<h4>What was done with its data</h4>\n" + bullet_list(e.handled);
}

/// Loops beside their residuals; of overhangs, the readings.
std::string loop_part(const ResultExperiment& e, const Prediction& prediction, std::size_t budget,
                      std::optional<MembraneMeasure> membrane, FigureSheet& figures) {
  LoopFigure loop = loop_figure(e, prediction, {.budget = budget, .membrane = membrane});
  loop.figure.print_size = kLoopSize;
  std::string drawn = e.measures_overhangs() || e.measures_readings() ? "Readings" : "Loops";
  if (loop.drawn < loop.total) {
    drawn += fmt::format(" ({} of {} points drawn)", loop.drawn, loop.total);
  }
  const std::string legend = figures.can_draw() ? legend_html(loop.legend) : std::string();
  return legend + "<div class=\"experiment\">\n" +
         captioned(drawn, figures.add(loop.figure, "figure-tall")) + "<div>\n" +
         residuals(e, prediction, budget / 2, membrane, figures) + "</div></div>\n";
}

std::string experiment_part(const ReportData& data, std::size_t i, std::size_t budget,
                            FigureSheet& figures) {
  const ResultExperiment& e = data.results.experiments[i];
  if (data.sheets[i]) return sheet_part(data, i, figures);
  std::string html = "<article class=\"figure-block\">\n<div class=\"together\">\n<h3>" +
                     escape_html(e.name) + "</h3>\n";
  html += fmt::format("<p class=\"description\">{}</p>\n",
                      escape_html(description(e, data.results.membrane, data.results.evaluation)));
  if (data.shapes[i]) {
    html += shape_part(e, *data.shapes[i], figures);
  } else {
    html += loop_part(e, data.predictions[i], budget, data.results.membrane, figures) + "</div>\n";
  }
  return html + handled(e) + "</article>\n";
}

}  // namespace

std::string experiment_section(const ReportData& data, FigureSheet& figures) {
  const std::vector<ResultExperiment>& experiments = data.results.experiments;
  if (experiments.empty()) return {};
  if (data.is_of_sheets()) return sheet_section(data, figures);
  std::string html =
      "<section id=\"experiments\"><h2>Experiments</h2>\n"
      "<p>Residuals without a pattern are noise of the measurement; a pattern against extension or "
      "curvature is "
      "what "
      "the material model cannot follow, a drift in the order measured is a change of the specimen "
      "or "
      "of the apparatus.</p>\n";
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    html += experiment_part(data, i, row_budget(experiments.size()), figures);
  }
  return html + "</section>\n";
}

}  // namespace pliant::report
