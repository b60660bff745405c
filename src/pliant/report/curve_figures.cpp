#include "pliant/report/curve_figures.h"

#include <algorithm>
#include <vector>

#include "pliant/report/histogram.h"
#include "pliant/report/plot_style.h"

namespace pliant::report {
namespace {

using nlohmann::json;

constexpr int kHistogramBins = 40;

constexpr SeriesStyle kElasticMaterial = {"material", "material", "#00538a", "solid", nullptr, 2.0};

std::vector<double> scaled(std::span<const double> values, double factor) {
  std::vector<double> result(values.begin(), values.end());
  for (double& value : result) value *= factor;
  return result;
}

/// Two traces: an invisible lower edge and an upper edge filled down to it.
void add_band(json& traces, const std::vector<double>& x, const ComponentCurve& curve) {
  const json hidden_line = {{"width", 0}};
  json low = {{"type", "scatter"},     {"mode", "lines"},      {"name", "95 % band"},
              {"legendgroup", "band"}, {"x", plot_numbers(x)}, {"y", plot_numbers(curve.low)},
              {"line", hidden_line},   {"hoverinfo", "skip"}};
  json high = low;
  high["y"] = plot_numbers(curve.high);
  high["fill"] = "tonexty";
  high["fillcolor"] = "rgba(0, 83, 138, 0.18)";
  traces.push_back(std::move(low));
  traces.push_back(std::move(high));
}

void add_histogram(Figure& figure, const std::vector<double>& x, std::span<const double> strains) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const Histogram histogram = make_histogram(strains, *low, *high, kHistogramBins);
  figure.traces.push_back({{"type", "bar"},
                           {"name", "measured points"},
                           {"x", plot_numbers(histogram.centres)},
                           {"y", plot_numbers(histogram.counts)},
                           {"width", histogram.bin_width},
                           {"marker", {{"color", "#a9b4bf"}}},
                           {"yaxis", "y2"},
                           {"hovertemplate", "%{y} points<extra></extra>"}});
  figure.layout["yaxis"]["domain"] = {0.3, 1.0};
  figure.layout["yaxis2"] = axis({"Points", ""});
  figure.layout["yaxis2"]["domain"] = {0.0, 0.2};
  figure.layout["yaxis2"]["nticks"] = 3;
  figure.layout["yaxis2"]["rangemode"] = "tozero";
  figure.layout["xaxis"]["anchor"] = "y2";
}

/// Axes of stress against strain, nothing drawn.
Figure empty_curve_figure(const std::string& component, const StrainScale& scale) {
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis(scale.label);
  figure.layout["yaxis"] = axis(stress_label(component));
  figure.description = "Stress against strain of " + component;
  figure.data_file = "curves.csv";
  return figure;
}

}  // namespace

bool has_friction(const ComponentCurve& curve) {
  return !curve.elastic.empty() &&
         std::ranges::any_of(curve.max_friction, [](double stress) { return stress > 0.0; });
}

Figure stress_strain_figure(const ComponentCurve& curve, std::span<const double> data_strains,
                            bool show_friction) {
  const StrainScale scale = strain_scale(curve.component);
  const std::vector<double> x = scaled(curve.strain, scale.factor);
  Figure figure = empty_curve_figure(curve.component, scale);
  if (!curve.low.empty() && !curve.high.empty() && show_friction) add_band(figure.traces, x, curve);
  if (!curve.elastic.empty()) figure.traces.push_back(trace(kElastic, x, curve.elastic));
  if (show_friction) {
    figure.traces.push_back(trace(kPredictedLoad, x, curve.load));
    figure.traces.push_back(trace(kPredictedUnload, x, curve.unload));
  }
  if (!x.empty() && !data_strains.empty()) {
    add_histogram(figure, x, scaled(data_strains, scale.factor));
  }
  return figure;
}

Figure sheet_curve_figure(const ComponentCurve& curve, std::span<const double> sheet_strains) {
  const StrainScale scale = strain_scale(curve.component);
  const std::vector<double> x = scaled(curve.strain, scale.factor);
  Figure figure = empty_curve_figure(curve.component, scale);
  if (!curve.low.empty() && !curve.high.empty()) add_band(figure.traces, x, curve);
  if (has_friction(curve)) {
    figure.traces.push_back(trace(kElastic, x, curve.elastic));
    figure.traces.push_back(trace(kPredictedLoad, x, curve.load));
    figure.traces.push_back(trace(kPredictedUnload, x, curve.unload));
  } else {
    figure.traces.push_back(trace(kElasticMaterial, x, curve.elastic));
  }
  if (!x.empty() && !sheet_strains.empty()) {
    add_histogram(figure, x, scaled(sheet_strains, scale.factor));
    figure.traces.back()["name"] = "elements of sheets";
    figure.traces.back()["hovertemplate"] = "%{y} elements<extra></extra>";
    figure.layout["yaxis2"]["title"]["text"] = "Elements";
  }
  return figure;
}

Figure friction_figure(const ComponentCurve& curve) {
  const StrainScale scale = strain_scale(curve.component);
  const std::vector<double> x = scaled(curve.strain, scale.factor);
  std::vector<double> load = curve.load;
  std::vector<double> unload = curve.unload;
  for (std::size_t i = 0; i < x.size(); ++i) {
    load[i] -= curve.elastic[i];
    unload[i] -= curve.elastic[i];
  }
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis(scale.label);
  figure.layout["yaxis"] = axis({"Friction stress", stress_label(curve.component).unit});
  figure.traces.push_back(trace(kEnvelope, x, curve.max_friction));
  figure.traces.push_back(trace(kEnvelope, x, scaled(curve.max_friction, -1.0)));
  figure.traces.push_back(trace(kPredictedLoad, x, load));
  figure.traces.push_back(trace(kPredictedUnload, x, unload));
  figure.description = "Friction stress against strain of " + curve.component;
  figure.data_file = "curves.csv";
  return figure;
}

}  // namespace pliant::report
