#include "pliant/report/shape_figures.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

constexpr std::size_t kChosen = 3;
constexpr std::array<const char*, kChosen> kGroups = {"setting-1", "setting-2", "setting-3"};
constexpr std::array<const char*, kChosen> kColors = {"#00538a", "#b34700", "#4a7a2c"};
constexpr std::array<const char*, kChosen> kSymbols = {"circle-open", "triangle-down-open",
                                                       "diamond-open"};

bool is_among(const std::vector<double>& settings, double setting) {
  return std::find(settings.begin(), settings.end(), setting) != settings.end();
}

SeriesStyle as_markers(SeriesStyle style, std::size_t number) {
  style.dash = nullptr;
  style.symbol = kSymbols[number];
  style.size = 4.5;
  return style;
}

using Member = std::vector<double> ShapeLine::*;

/// Some of the points: those that took part, or those that were left out. The clamp is neither.
struct ChosenPoints {
  std::vector<double> x, y;

  void add(const ShapeLine& line, Member along_x, Member along_y, bool used) {
    for (std::size_t i = 1; i < line.used.size(); ++i) {
      if ((line.used[i] != 0) != used) continue;
      x.push_back((line.*along_x)[i]);
      y.push_back((line.*along_y)[i]);
    }
  }
};

/// Where the lines are and all but a few points: those that a spline throws far off at the ends of
/// a profile would squeeze the rest.
nlohmann::json range_of(const StripShapes& shapes, Member member) {
  constexpr double kOutliers = 0.03;  // of the points, on each side
  std::vector<double> values;
  for (const ShapeLine& line : shapes.measured) {
    values.insert(values.end(), (line.*member).begin() + 1, (line.*member).end());
  }
  std::sort(values.begin(), values.end());
  const auto cut = static_cast<std::size_t>(kOutliers * static_cast<double>(values.size()));
  double low = values[cut], high = values[values.size() - 1 - cut];
  for (const ShapeLine& line : shapes.predicted) {
    const auto [least, most] = std::minmax_element((line.*member).begin(), (line.*member).end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const double margin = 0.08 * (high - low);
  return {low - margin, high + margin};
}

/// Points and lines of the chosen settings, each in its colour.
Figure chosen_figure(const StripShapes& shapes, Member along_x, Member along_y,
                     bool with_predicted) {
  Figure figure;
  figure.layout = base_layout();
  const std::vector<double> settings = chosen_settings(shapes);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string text = setting_text(shapes, settings[i]);
    const SeriesStyle style = setting_style(i, text);
    ChosenPoints points;
    for (const ShapeLine& line : shapes.measured) {
      if (line.setting_mm == settings[i]) points.add(line, along_x, along_y, true);
    }
    figure.traces.push_back(trace(as_markers(style, i), points.x, points.y));
    for (const ShapeLine& line : shapes.predicted) {
      if (line.setting_mm != settings[i] || !with_predicted) continue;
      figure.traces.push_back(trace(style, line.*along_x, line.*along_y));
    }
  }
  return figure;
}

}  // namespace

std::string setting_text(const StripShapes& shapes, double setting_mm) {
  return fmt::format("{} {:.4g} mm", shapes.setting, setting_mm);
}

std::vector<double> chosen_settings(const StripShapes& shapes) {
  const std::vector<double> all = shapes.settings();
  if (all.size() <= kChosen) return all;
  return {all.front(), all[all.size() / 2], all.back()};
}

SeriesStyle setting_style(std::size_t number, const std::string& text) {
  return {kGroups[number], text.c_str(), kColors[number], "solid", nullptr, 2.0};
}

Figure side_view(const StripShapes& shapes, const std::vector<double>& settings, bool compact) {
  ChosenPoints used, left_out;
  for (const ShapeLine& line : shapes.measured) {
    if (!is_among(settings, line.setting_mm)) continue;
    used.add(line, &ShapeLine::x_mm, &ShapeLine::y_mm, true);
    left_out.add(line, &ShapeLine::x_mm, &ShapeLine::y_mm, false);
  }
  Figure figure;
  figure.layout = base_layout(compact);
  figure.layout["xaxis"] = axis({"x", "mm"}, compact);
  figure.layout["yaxis"] = axis({"y", "mm"}, compact);
  figure.layout["yaxis"]["scaleanchor"] = "x";  // a circle stays a circle
  figure.traces.push_back(trace(kMeasuredShape, used.x, used.y, compact));
  if (!left_out.x.empty()) {
    figure.traces.push_back(trace(kExcluded, left_out.x, left_out.y, compact));
  }
  for (const ShapeLine& line : shapes.predicted) {
    if (!is_among(settings, line.setting_mm)) continue;
    figure.traces.push_back(trace(kPredictedShape, line.x_mm, line.y_mm, compact));
  }
  figure.description = "Side view of the strips, measured and predicted";
  return figure;
}

Figure curvature_figure(const StripShapes& shapes) {
  Figure figure = chosen_figure(shapes, &ShapeLine::arc_length_mm, &ShapeLine::curvature, true);
  figure.layout["xaxis"] = axis({"Distance from the clamp along the strip", "mm"});
  figure.layout["yaxis"] = axis({"Curvature", "1/m"});
  figure.layout["yaxis"]["range"] = range_of(shapes, &ShapeLine::curvature);
  figure.description = "Curvature along the strips, measured and predicted";
  return figure;
}

Figure moment_figure(const StripShapes& shapes) {
  const bool rolled = !shapes.bent.empty();
  Figure figure = chosen_figure(shapes, &ShapeLine::curvature, &ShapeLine::moment, !rolled);
  figure.layout["xaxis"] = axis({"Curvature", "1/m"});
  if (!rolled) figure.layout["xaxis"]["range"] = range_of(shapes, &ShapeLine::curvature);
  const std::vector<double> settings = chosen_settings(shapes);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string text = setting_text(shapes, settings[i]);
    for (const ShapeLine& path : shapes.bent) {
      if (path.setting_mm != settings[i]) continue;
      figure.traces.push_back(trace(setting_style(i, text), path.curvature, path.moment));
    }
  }
  set_readable_axis(figure, 'y', {"Moment per width", "N"});
  figure.description = "Moment over curvature of the strips";
  return figure;
}

Figure distance_figure(const StripShapes& shapes) {
  ChosenPoints points;
  for (const ShapeLine& line : shapes.measured) {
    points.add(line, &ShapeLine::arc_length_mm, &ShapeLine::distance_mm, true);
  }
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis({"Distance from the clamp along the strip", "mm"}, true);
  figure.layout["yaxis"] = axis({"Distance", "mm"}, true);
  figure.layout["yaxis"]["nticks"] = 6;
  figure.traces.push_back(trace(kMeasuredShape, points.x, points.y));
  figure.description = "Distance of the measured points from the predicted profiles";
  return figure;
}

}  // namespace pliant::report
