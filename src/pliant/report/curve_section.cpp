#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "pliant/material/material.h"
#include "pliant/report/curve_figures.h"
#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/sections.h"
#include "pliant/report/sheet_strains.h"

namespace pliant::report {
namespace {

constexpr PrintSize kCurveSize = {345, 228};

/// Bending is drawn to one side: what bends to the other counts alike.
double drawn_strain(const std::string& component, double strain) {
  return component.starts_with("bend") ? std::abs(strain) : strain;
}

/// Strains of the rows that shaped the component: of fitted experiments, or of all that are
/// compared in an evaluation.
std::vector<double> data_strains(const ReportData& data, const std::string& component) {
  std::vector<double> strains;
  for (std::size_t i = 0; i < data.predictions.size(); ++i) {
    const ResultExperiment& e = data.results.experiments[i];
    if (e.measures_sheets()) continue;  // their rows are not of one strain
    if (e.component != component || (e.validation && !data.results.evaluation)) continue;
    const Prediction& p = data.predictions[i];
    for (std::size_t row = 0; row < p.rows(); ++row) {
      if (p.used[row]) strains.push_back(drawn_strain(component, p.strain[row]));
    }
  }
  return strains;
}

bool any_undetermined(const Results& results, const std::string& component, bool friction) {
  return std::any_of(results.parameters.begin(), results.parameters.end(),
                     [&](const ResultParameter& p) {
                       return p.component == component && !p.fixed && !p.identified &&
                              is_of_friction(p.name) == friction;
                     });
}

std::string captioned(std::string_view caption, Figure figure, FigureSheet& figures) {
  figure.print_size = kCurveSize;
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption,
                     figures.add(figure, "figure-tall"));
}

std::string_view kind_of(std::string_view component) {
  return component.substr(0, component.find('.'));
}

/// The fitted sessions of the test that tells a component, or of those that tell its kind: diagonal
/// bending shows in the bends along weft and warp.
std::vector<const Session*> telling_sessions(const ReportData& data, const std::string& component) {
  std::vector<const Session*> of_component, of_kind;
  for (std::size_t i = 0; i < data.sheets.size(); ++i) {
    const ResultExperiment& e = data.results.experiments[i];
    if (e.validation) continue;
    const Session* predicted = &data.sheets[i]->session.predicted;
    if (e.component == component) of_component.push_back(predicted);
    if (kind_of(e.component) == kind_of(component)) of_kind.push_back(predicted);
  }
  return of_component.empty() ? of_kind : of_component;
}

/// Strains of the fitted sheets. The curve of a component that is not even begins at zero: what is
/// below is not drawn.
std::vector<double> strains_of_sheets(const ReportData& data, const std::string& component) {
  std::vector<double> strains;
  if (!data.material || !data.material->components.contains(component)) return strains;
  const bool even = is_even(component);
  for (const Session* session : telling_sessions(data, component)) {
    for (const double strain : sheet_strains(*session, *data.material, component)) {
      if (even || strain >= 0) strains.push_back(std::abs(strain));
    }
  }
  return strains;
}

/// A cycle where the component has friction, else one line, and the strains of the sheets under it.
std::string sheet_curve_part(const ReportData& data, const ComponentCurve& curve,
                             FigureSheet& figures) {
  const std::string caption = fmt::format(
      "<strong>{}</strong>{}; below, how many elements of the sheets fitted to it have each strain",
      escape_html(component_title(curve.component)),
      any_undetermined(data.results, curve.component, false)
          ? ": part of its stiffness is not determined by the data"
          : "");
  return captioned(
      caption,
      sheet_curve_figure(curve, data.results.membrane, strains_of_sheets(data, curve.component)),
      figures);
}

/// Whether the data tell how wide the loop of a component is; that all numbers of its friction are
/// told is more than that.
bool knows_loop(const Results& results, const std::string& component) {
  const auto loop = std::ranges::find_if(results.figures, [&](const ResultFigure& figure) {
    return figure.component == component &&
           (figure.name == "loop_width" || figure.name == "kes_2HB");
  });
  if (loop != results.figures.end() && loop->std_error) return loop->is_determined();
  return !any_undetermined(results, component, true);
}

std::string curve_part(const ReportData& data, const ComponentCurve& curve, FigureSheet& figures) {
  const std::vector<double> strains = data_strains(data, curve.component);
  const bool friction_known = knows_loop(data.results, curve.component);
  const bool draws_friction = friction_known && has_friction(curve);
  std::vector<SeriesStyle> legend;
  if (!curve.elastic.empty()) legend.push_back(kElastic);
  if (friction_known) legend.insert(legend.end(), {kPredictedLoad, kPredictedUnload});
  if (draws_friction) legend.push_back(kEnvelope);
  std::string html = "<article class=\"figure-block together\">\n<h3>" +
                     escape_html(component_title(curve.component)) + "</h3>\n";
  if (any_undetermined(data.results, curve.component, false)) {
    html +=
        "<p>Part of its stiffness is not determined by the data: read the curve only where the "
        "data stand.</p>\n";
  }
  if (!friction_known) {
    html += "<p>Its friction is not determined by the data and not drawn.</p>\n";
  } else if (any_undetermined(data.results, curve.component, true)) {
    html += "<p>How wide its loops are is determined by the data, not each number of it.</p>\n";
  }
  if (figures.can_draw()) html += legend_html(legend);
  html += "<div class=\"pair\">\n";
  html += captioned(
      friction_known && !curve.low.empty()
          ? "Stress against strain, 95 % band of the loading branch; below, the number of "
            "measured points at each strain"
          : "Stress against strain; below, the number of measured points at each strain",
      stress_strain_figure(curve, data.results.membrane, strains, friction_known), figures);
  if (draws_friction) {
    html += captioned("Friction stress of the same cycle; it tends to its saturated value",
                      friction_figure(curve, data.results.membrane), figures);
  }
  return html + "</div></article>\n";
}

std::string sheet_curves(const ReportData& data, FigureSheet& figures) {
  const bool rubs = std::ranges::any_of(data.curves, has_friction);
  std::string html =
      "<section id=\"curves\" class=\"figure-block\"><div class=\"together\">"
      "<h2>Stress-strain curves</h2>\n"
      "<p>The material at strains up to the largest in the fitted sheets, with a 95 % band. Where "
      "few elements stand below, the curve leans on few of them.";
  if (rubs) {
    html +=
        " Components with friction are shown in one cycle from rest to the largest strain and "
        "back, with the band of loading.";
  }
  html += "</p>\n";
  if (rubs && figures.can_draw()) {
    html += legend_html(std::vector{kElastic, kPredictedLoad, kPredictedUnload});
  }
  html += "<div class=\"pair\">\n";
  for (std::size_t i = 0; i < data.curves.size(); ++i) {
    if (i == 2) html += "</div></div>\n<div><div class=\"pair\">\n";
    html += sheet_curve_part(data, data.curves[i], figures);
  }
  return html + "</div></div></section>\n";
}

}  // namespace

std::string curve_section(const ReportData& data, FigureSheet& figures) {
  if (data.curves.empty()) return {};
  if (data.is_of_sheets()) return sheet_curves(data, figures);
  std::string html =
      "<section id=\"curves\"><div class=\"together\"><h2>Stress-strain curves</h2>\n"
      "<p>The material without its test: one cycle from rest to the largest strain and back. Where "
      "there are no measured points the curve is extrapolated.</p>\n";
  for (std::size_t i = 0; i < data.curves.size(); ++i) {
    html += curve_part(data, data.curves[i], figures);
    if (i == 0) html += "</div>\n";
  }
  return html + "</section>\n";
}

}  // namespace pliant::report
