#include "pliant/report/shape_part.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/shape_figures.h"

namespace pliant::report {
namespace {

constexpr PrintSize kViewSize = {226, 190};
constexpr PrintSize kPairSize = {345, 260};
constexpr PrintSize kDistanceSize = {703, 150};
constexpr std::size_t kMostViews = 24;
constexpr std::size_t kViewsOfAPage = 9;

std::string captioned(std::string_view caption, Figure figure, PrintSize size,
                      std::string_view css_class, const ResultExperiment& e, FigureSheet& figures) {
  figure.print_size = size;
  figure.data_file = e.shape_file;
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption,
                     figures.add(figure, css_class));
}

std::string explanation(const StripShapes& shapes) {
  if (shapes.setting == "radius") {
    return "<p>Each strip was rolled around a cylinder, let go, and photographed from the side as "
           "it hangs from its clamp (at 0, 0), the weight pulling downwards. Without internal "
           "friction it would come back flat but for its weight: the coil that stays is "
           "friction. The clamp itself, where every profile begins, is not compared.</p>\n";
  }
  return "<p>Each strip sticks out of its clamp (at 0, 0) and bends under its own weight: the "
         "longer it is and the softer, the further. The clamp itself, where every profile begins, "
         "is not compared.</p>\n";
}

std::string views(const ResultExperiment& e, const StripShapes& shapes, FigureSheet& figures) {
  std::vector<double> settings = shapes.settings();
  const std::size_t all = settings.size();
  settings.resize(std::min(all, kMostViews));
  std::string html = figures.can_draw() ? legend_html(std::vector{kMeasuredShape, kPredictedShape})
                                        : std::string();
  html += "<div class=\"loops\">\n";
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const double setting = settings[i];
    if (i == kViewsOfAPage) html += "</div>\n</div>\n<div>\n<div class=\"loops\">\n";
    Figure view = side_view(shapes, {setting}, /*compact=*/true);
    view.description += ", " + setting_text(shapes, setting) + ", " + e.name;
    html += captioned(escape_html(setting_text(shapes, setting)), std::move(view), kViewSize,
                      "figure-small", e, figures);
  }
  html += "</div>\n</div>\n";
  if (all > settings.size()) {
    html += element("p", fmt::format("{} more are in {}.", all - settings.size(), e.shape_file));
  }
  return html;
}

std::string setting_legend(const StripShapes& shapes) {
  std::vector<std::string> texts;
  for (const double setting : chosen_settings(shapes)) {
    texts.push_back(setting_text(shapes, setting));
  }
  std::vector<SeriesStyle> styles;
  for (std::size_t i = 0; i < texts.size(); ++i) styles.push_back(setting_style(i, texts[i]));
  return legend_html(styles);
}

std::string moment_caption(const StripShapes& shapes) {
  if (shapes.bent.empty()) {
    return "Moment over curvature. Points: moment of the weight that hangs beyond a measured "
           "point; lines: the material";
  }
  return "Moment over curvature. Lines: the material, bent to the cylinder (upper branch) and let "
         "go (lower branch). Points: moment of the weight that hangs beyond a measured point; "
         "where the lower branch meets them, the strip comes to rest";
}

}  // namespace

std::string shape_part(const ResultExperiment& e, const StripShapes& shapes, FigureSheet& figures) {
  std::string html = explanation(shapes) + views(e, shapes, figures);
  if (figures.can_draw()) html += setting_legend(shapes);
  html += "<div class=\"pair\">\n";
  html += captioned(
      "Curvature along the strip. Points: measured, by a spline through the points, "
      "which is rough at the ends; lines: the material",
      curvature_figure(shapes), kPairSize, "figure-medium", e, figures);
  html += captioned(moment_caption(shapes), moment_figure(shapes), kPairSize, "figure-medium", e,
                    figures);
  html += "</div>\n";
  return html + captioned(
                    "Distance of each measured point from the predicted profile; above zero "
                    "the profile passes on the left of the point, seen from the clamp",
                    distance_figure(shapes), kDistanceSize, "figure-short", e, figures);
}

}  // namespace pliant::report
