#include "pliant/report/profile_figure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/math/quantiles.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

using nlohmann::json;

constexpr SeriesStyle kProfile = {"profile", "profile", "#00538a", "solid", nullptr, 2.0};
constexpr SeriesStyle kParabola = {"parabola", "standard error", "#b34700",
                                   "6px,3px",  nullptr,          1.6};

json level_line(double level) {
  return {{"type", "line"},
          {"xref", "paper"},
          {"x0", 0},
          {"x1", 1},
          {"y0", level},
          {"y1", level},
          {"line", {{"color", "#555f6b"}, {"width", 1}}}};
}

json limit_line(double value) {
  return {{"type", "line"},
          {"yref", "paper"},
          {"x0", value},
          {"x1", value},
          {"y0", 0},
          {"y1", 1},
          {"line", {{"color", "#555f6b"}, {"width", 1}, {"dash", "2px,3px"}}}};
}

std::vector<double> parabola(const Profile& profile, double std_error) {
  const auto best = std::min_element(profile.delta_chi2.begin(), profile.delta_chi2.end());
  const double centre = profile.value[static_cast<std::size_t>(best - profile.delta_chi2.begin())];
  std::vector<double> values;
  for (const double value : profile.value)
    values.push_back(std::pow((value - centre) / std_error, 2));
  return values;
}

}  // namespace

Profile in_readable_unit(Profile profile) {
  double largest = 0;
  for (const double value : profile.value) largest = std::max(largest, std::abs(value));
  const ReadableUnit unit = readable_unit(profile.unit, largest);
  for (double& value : profile.value) value *= unit.factor;
  for (auto* number : {&profile.lower, &profile.upper, &profile.std_error}) {
    if (*number) **number *= unit.factor;
  }
  profile.unit = unit.name;
  return profile;
}

Figure profile_figure(const Profile& profile) {
  const double threshold = chi_square_quantile(0.95, 1);
  Figure figure;
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis({"Value", shown_unit(profile.unit)});
  figure.layout["yaxis"] = axis({"Increase of chi²", ""});
  json shapes = json::array({level_line(threshold)});
  if (profile.lower) shapes.push_back(limit_line(*profile.lower));
  if (profile.upper) shapes.push_back(limit_line(*profile.upper));
  figure.layout["shapes"] = std::move(shapes);
  figure.traces.push_back(trace(kProfile, profile.value, profile.delta_chi2));
  if (!profile.value.empty()) {
    const double top = *std::max_element(profile.delta_chi2.begin(), profile.delta_chi2.end());
    figure.layout["yaxis"]["range"] = {0.0, 1.05 * std::max(top, threshold)};
    if (profile.std_error && *profile.std_error > 0.0) {
      figure.traces.push_back(
          trace(kParabola, profile.value, parabola(profile, *profile.std_error)));
    }
  }
  figure.description = "Profile likelihood of " + profile.parameter;
  figure.data_file = "fit.json (profiles)";
  return figure;
}

}  // namespace pliant::report
