#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sample_figure.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

constexpr PrintSize kSampleSize = {345, 200};
constexpr double kMillimetres = 1000;

/// `0: (25, 50)`, one a sample, in mm.
std::string places_in_words(const Material& material) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < material.samples.at.size(); ++i) {
    const Eigen::Vector3d at = kMillimetres * material.samples.at[i].place;
    std::string text =
        fmt::format("{}: ({}, {}", i, format_significant(at.x(), 3), format_significant(at.y(), 3));
    if (material.kind == MaterialKind::solid) text += ", " + format_significant(at.z(), 3);
    places.push_back(text + ")");
  }
  return fmt::format(
      "Samples at {} mm, at rest; between them the material is blended by normalised Gaussian "
      "weights of width {} mm.",
      fmt::join(places, ", "), format_significant(kMillimetres * material.samples.width, 3));
}

}  // namespace

std::string sample_section(const ReportData& data, FigureSheet& figures) {
  const std::vector<SampledNumber> numbers = sampled_numbers(data.results.parameters);
  if (numbers.empty()) return {};
  std::string html = fmt::format(
      "<section id=\"samples\"><h2>From place to place</h2>\n"
      "<p>The material differs from place to place. Its numbers at each sample, with 95 % "
      "intervals; crosses: not determined by the data. <code>{}</code> is a map for "
      "ParaView.</p>\n",
      data.results.is_of_solid() ? "body.vtu" : "sheet.vtu");
  if (data.material) {
    html += "<p class=\"small\">" + escape_html(places_in_words(*data.material)) + "</p>\n";
  }
  html += "<div class=\"pair\">\n";
  for (const SampledNumber& number : numbers) {
    Figure figure = sample_figure(number);
    figure.print_size = kSampleSize;
    html += fmt::format("<figure><figcaption><code>{}</code></figcaption>\n{}</figure>\n",
                        escape_html(number.name), figures.add(figure, "figure-medium"));
  }
  return html + "</div></section>\n";
}

}  // namespace pliant::report
