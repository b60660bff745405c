#include "pliant/report/curve_figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/base/number_text.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/report/histogram.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"

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

/// 1, 2 or 5 times a power of ten: of at most five ticks up to a strain.
double tick_step(double largest) {
  constexpr double kMostTicks = 5;
  const double least = largest / kMostTicks;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= least) return digit * decade;
  }
  return 10 * decade;
}

/// Green strain along the top where extension is along the bottom: the stress works on that.
void add_green_strain(const ComponentCurve& curve, Figure& figure) {
  const double largest = std::ranges::max(curve.strain);
  if (!(largest > 0)) return;
  const double step = tick_step(largest);
  json at = json::array(), text = json::array();
  for (double strain = 0; strain <= largest; strain += step) {
    at.push_back(100 * extension_at(MembraneMeasure::stvk, strain));
    text.push_back(format_number(100 * strain, 3));
  }
  json top = axis({"Green strain", "%"});
  top.update({{"overlaying", "x"},
              {"matches", "x"},
              {"anchor", "y"},
              {"side", "top"},
              {"showgrid", false},
              {"zeroline", false},
              {"tickvals", at},
              {"ticktext", text}});
  figure.layout["xaxis2"] = std::move(top);
  // An axis that no trace is on is not drawn.
  figure.traces.push_back({{"type", "scatter"},
                           {"legendgroup", "axis"},
                           {"xaxis", "x2"},
                           {"x", {0}},
                           {"y", {nullptr}},
                           {"hoverinfo", "skip"}});
}

/// Axes, once everything but a histogram is drawn.
void add_axes(const ComponentCurve& curve, const ShownStrain& shown, const QuantityLabel& stress,
              Figure& figure) {
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis(shown.label());
  set_readable_axis(figure, 'y', stress, /*compact=*/true);
  if (shown.is_of_green_strain() && !curve.strain.empty()) add_green_strain(curve, figure);
  figure.description = stress.name + " against strain of " + curve.component;
  figure.data_file = "curves.csv";
}

}  // namespace

bool has_friction(const ComponentCurve& curve) {
  return !curve.elastic.empty() &&
         std::ranges::any_of(curve.max_friction, [](double stress) { return stress > 0.0; });
}

Figure stress_strain_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane,
                            std::span<const double> data_strains, bool show_friction) {
  const ShownStrain shown(curve.component, membrane);
  const std::vector<double> x = shown(curve.strain);
  Figure figure;
  if (!curve.low.empty() && !curve.high.empty() && show_friction) add_band(figure.traces, x, curve);
  if (!curve.elastic.empty()) figure.traces.push_back(trace(kElastic, x, curve.elastic));
  if (show_friction) {
    figure.traces.push_back(trace(kPredictedLoad, x, curve.load));
    figure.traces.push_back(trace(kPredictedUnload, x, curve.unload));
  }
  add_axes(curve, shown, stress_label(curve.component), figure);
  if (!x.empty() && !data_strains.empty()) add_histogram(figure, x, shown(data_strains));
  return figure;
}

Figure sheet_curve_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane,
                          std::span<const double> sheet_strains) {
  const ShownStrain shown(curve.component, membrane);
  const std::vector<double> x = shown(curve.strain);
  Figure figure;
  if (!curve.low.empty() && !curve.high.empty()) add_band(figure.traces, x, curve);
  if (has_friction(curve)) {
    figure.traces.push_back(trace(kElastic, x, curve.elastic));
    figure.traces.push_back(trace(kPredictedLoad, x, curve.load));
    figure.traces.push_back(trace(kPredictedUnload, x, curve.unload));
  } else {
    figure.traces.push_back(trace(kElasticMaterial, x, curve.elastic));
  }
  add_axes(curve, shown, stress_label(curve.component), figure);
  if (!x.empty() && !sheet_strains.empty()) {
    add_histogram(figure, x, shown(sheet_strains));
    figure.traces.back()["name"] = "elements of sheets";
    figure.traces.back()["hovertemplate"] = "%{y} elements<extra></extra>";
    figure.layout["yaxis2"]["title"]["text"] = "Elements";
  }
  return figure;
}

Figure friction_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane) {
  const ShownStrain shown(curve.component, membrane);
  const std::vector<double> x = shown(curve.strain);
  std::vector<double> load = curve.load;
  std::vector<double> unload = curve.unload;
  for (std::size_t i = 0; i < x.size(); ++i) {
    load[i] -= curve.elastic[i];
    unload[i] -= curve.elastic[i];
  }
  Figure figure;
  figure.traces.push_back(trace(kEnvelope, x, curve.max_friction));
  figure.traces.push_back(trace(kEnvelope, x, scaled(curve.max_friction, -1.0)));
  figure.traces.push_back(trace(kPredictedLoad, x, load));
  figure.traces.push_back(trace(kPredictedUnload, x, unload));
  add_axes(curve, shown, {"Friction stress", stress_label(curve.component).unit}, figure);
  return figure;
}

}  // namespace pliant::report
