#include <cmath>

#include <fmt/format.h>

#include "pliant/report/correlation.h"
#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

/// From here on two estimates can hardly be told apart by the data.
constexpr double kStrong = 0.95;

/// White at 0, blue towards 1, orange towards -1; the text turns white where the ground is dark.
std::string cell_style(double correlation) {
  const double strength = std::abs(correlation);
  const char* ground = correlation >= 0.0 ? "0,83,138" : "179,71,0";
  return fmt::format("background:rgba({},{:.2f}){}", ground, 0.85 * strength,
                     strength > 0.6 ? ";color:#fff" : "");
}

/// Without the sign of a negative zero.
std::string two_decimals(double value) {
  return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
}

std::string heat_map(const CorrelationBlock& block) {
  // On paper a table that is too wide makes everything smaller: colours alone say it.
  constexpr std::size_t kMostNumbers = 14;
  std::string html =
      fmt::format("<div class=\"table-box\"><table class=\"heat-map{}\">\n<thead><tr><th></th>",
                  block.names.size() > kMostNumbers ? " heat-map-large" : "");
  for (std::size_t i = 0; i < block.names.size(); ++i) {
    html += fmt::format("<th scope=\"col\">{}</th>", i + 1);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < block.names.size(); ++i) {
    html += fmt::format("<tr><th scope=\"row\">{} <code>{}</code></th>", i + 1,
                        escape_html(block.names[i]));
    for (const double value : block.values[i]) {
      html += std::isfinite(value)
                  ? fmt::format("<td style=\"{}\">{}</td>", cell_style(value), two_decimals(value))
                  : fmt::format("<td>{}</td>", kNoValue);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string strong_pairs(const CorrelationBlock& block) {
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < block.names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double value = block.values[i][j];
      if (std::abs(value) < kStrong || !std::isfinite(value)) continue;
      pairs.push_back(fmt::format("{} and {} ({:.2f})", block.names[j], block.names[i], value));
    }
  }
  if (pairs.empty()) return {};
  return "<p>Hard to tell apart by these data:</p>\n" + bullet_list(pairs);
}

}  // namespace

std::string correlation_section(const Results& results) {
  const std::vector<CorrelationBlock> blocks = correlation_blocks(results);
  if (blocks.empty()) return {};
  std::string html =
      "<section id=\"correlations\"><h2>Correlations of the estimates</h2>\n"
      "<p>Near 1 or -1, an error in one parameter is made up by the other: their combination is "
      "known "
      "better than each alone. Columns are numbered like the rows. Components that share no data "
      "are not correlated and have tables of their own.</p>\n";
  for (const CorrelationBlock& block : blocks) {
    html += element("h3", block.title) + heat_map(block) + strong_pairs(block);
  }
  return html + "</section>\n";
}

}  // namespace pliant::report
