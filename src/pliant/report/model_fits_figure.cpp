#include "pliant/report/model_fits_figure.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "pliant/report/labels.h"

namespace pliant::report {
namespace {

// Dark, middle and light, so that grey print tells them apart.
constexpr std::array<SeriesStyle, 3> kStyles = {
    {{"soft-constraint", "Soft constraints", "#00538a", nullptr, "square", 0},
     {"stvk", "St. Venant-Kirchhoff", "#e58a2c", nullptr, "square", 0},
     {"springs", "Springs", "#c3cdd6", nullptr, "square", 0}}};

/// Each once, in the order of the rows.
std::vector<std::string> names_of(const ModelComparison& comparison,
                                  std::string ComparedFit::*name) {
  std::vector<std::string> names;
  for (const ComparedFit& row : comparison.fits) {
    if (std::ranges::find(names, row.*name) == names.end()) names.push_back(row.*name);
  }
  return names;
}

/// In two lines: labels of four groups stand side by side.
std::string tick_of(std::string variant) {
  const std::size_t dash = variant.find('-');
  if (dash != std::string::npos) variant.replace(dash, 1, "<br>");
  return variant;
}

std::vector<double> errors_of(const ModelComparison& comparison, const std::string& model,
                              const std::vector<std::string>& variants, std::size_t session) {
  std::vector<double> errors;
  for (const std::string& variant : variants) {
    const auto row = std::ranges::find_if(comparison.fits, [&](const ComparedFit& one) {
      return one.model == model && one.variant == variant;
    });
    const auto error = row == comparison.fits.end() ? std::nullopt : row->error(session);
    errors.push_back(error.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return errors;
}

}  // namespace

std::vector<SeriesStyle> model_styles(const ModelComparison& comparison) {
  std::vector<SeriesStyle> styles;
  for (const std::string& model : names_of(comparison, &ComparedFit::model)) {
    const auto* style =
        std::ranges::find_if(kStyles, [&](const SeriesStyle& one) { return one.group == model; });
    if (style != kStyles.end()) styles.push_back(*style);
  }
  return styles;
}

Figure model_fits_figure(const ModelComparison& comparison, std::size_t session) {
  const std::vector<std::string> variants = names_of(comparison, &ComparedFit::variant);
  nlohmann::json ticks = nlohmann::json::array();
  for (const std::string& variant : variants) ticks.push_back(tick_of(variant));
  Figure figure;
  for (const SeriesStyle& style : model_styles(comparison)) {
    figure.traces.push_back(
        {{"type", "bar"},
         {"name", style.name},
         {"legendgroup", style.group},
         {"x", ticks},
         {"y", plot_numbers(errors_of(comparison, style.group, variants, session))},
         {"marker", {{"color", style.color}}},
         {"hovertemplate", "%{y:.4~g} " + comparison.sessions[session].unit}});
  }
  figure.layout = base_layout(/*compact=*/true);
  figure.layout["barmode"] = "group";
  figure.layout["bargap"] = 0.25;
  figure.layout["xaxis"] = axis({}, /*compact=*/true);
  figure.layout["xaxis"]["type"] = "category";
  figure.layout["xaxis"]["tickangle"] = 0;
  figure.layout["xaxis"]["ticks"] = "";
  figure.layout["yaxis"] = axis({"RMS error", comparison.sessions[session].unit}, /*compact=*/true);
  figure.layout["yaxis"]["rangemode"] = "tozero";
  figure.description =
      fmt::format("RMS errors of {} by variant and model", comparison.sessions[session].name);
  figure.data_file = "summary.csv";
  return figure;
}

}  // namespace pliant::report
