#include "pliant/experiment/drape/silhouette_picture.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pliant/io/xml_text.h"

namespace pliant {
namespace {

constexpr double kMargin = 6, kTitle = 12, kLine = 8;  // mm of the picture, which is to scale

/// A closed line through the radii of an outline; y goes down in pictures.
std::string path_of(const std::vector<double>& radii) {
  std::string path;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
    path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : " L", 1e3 * radii[i] * std::cos(angle),
                        -1e3 * radii[i] * std::sin(angle));
  }
  return path + " Z";
}

std::string circle(double diameter, const char* style) {
  return fmt::format("<circle r=\"{:.2f}\" {}/>\n", 1e3 * diameter / 2, style);
}

std::string figures_text(const NamedSilhouette& draped) {
  const DrapeFigures& figures = draped.sheet.figures;
  return fmt::format("{}: drape coefficient {:.1f} %, {} nodes", xml_text(draped.name),
                     100 * figures.coefficient, figures.nodes);
}

}  // namespace

std::string silhouette_picture(const std::string& title, const std::vector<NamedSilhouette>& draped,
                               const DrapeSetup& setup) {
  const double half = 1e3 * setup.specimen / 2 + kMargin;
  const double below = kLine * static_cast<double>(draped.size()) + kMargin;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}mm\" height=\"{1:.0f}mm\" "
      "viewBox=\"{2:.2f} {3:.2f} {0:.2f} {1:.2f}\" font-family=\"sans-serif\" font-size=\"6\">\n"
      "<rect x=\"{2:.2f}\" y=\"{3:.2f}\" width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      2 * half, 2 * half + kTitle + below, -half, -half - kTitle);
  svg +=
      fmt::format("<text x=\"0\" y=\"{:.2f}\" text-anchor=\"middle\" font-size=\"8\">{}</text>\n",
                  -half, xml_text(title));
  svg += circle(setup.specimen,
                "fill=\"none\" stroke=\"#888\" stroke-width=\"0.4\" "
                "stroke-dasharray=\"3 2\"");
  for (const auto& [name, sheet] : draped) {
    svg += fmt::format(
        "<path d=\"{}\" fill=\"#1f77b4\" fill-opacity=\"{:.2f}\" stroke=\"#1f77b4\" "
        "stroke-width=\"0.6\"/>\n",
        path_of(sheet.silhouette.radii), 0.3 / static_cast<double>(draped.size()));
  }
  svg +=
      circle(setup.disc, "fill=\"#ddd\" fill-opacity=\"0.6\" stroke=\"#555\" stroke-width=\"0.4\"");
  for (std::size_t i = 0; i < draped.size(); ++i) {
    svg += fmt::format("<text x=\"0\" y=\"{:.2f}\" text-anchor=\"middle\">{}</text>\n",
                       half + kLine * static_cast<double>(i + 1) - kMargin / 2,
                       figures_text(draped[i]));
  }
  return svg + "</svg>\n";
}

}  // namespace pliant
