#include "pliant/report/plot_style.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/base/number_text.h"

namespace pliant::report {
namespace {

using nlohmann::json;

constexpr int kPlotDigits = 5;

/// More markers than this run into each other at their full size.
constexpr std::size_t kCrowded = 250;

/// A small drawing of the line or the marker for the legend.
std::string swatch(const SeriesStyle& style) {
  constexpr std::string_view kOpen = "<svg width=\"30\" height=\"10\" aria-hidden=\"true\">";
  if (style.dash != nullptr) {
    const std::string dash = std::string_view(style.dash) == "solid"
                                 ? std::string()
                                 : fmt::format(" stroke-dasharray=\"{}\"", style.dash);
    return fmt::format(
        "{}<line x1=\"1\" y1=\"5\" x2=\"29\" y2=\"5\" stroke=\"{}\" stroke-width=\"{}\"{}/></svg>",
        kOpen, style.color, style.size, dash);
  }
  const std::string_view symbol = style.symbol;
  if (symbol == "square") {
    return fmt::format("{}<path d=\"M10 0H20V10H10Z\" fill=\"{}\"/></svg>", kOpen, style.color);
  }
  std::string shape = "<circle cx=\"15\" cy=\"5\" r=\"3\"";
  if (symbol.starts_with("triangle-down")) shape = "<path d=\"M11 2H19L15 9Z\"";
  if (symbol.starts_with("diamond")) shape = "<path d=\"M15 1L19 5L15 9L11 5Z\"";
  if (symbol.starts_with("x")) shape = "<path d=\"M12 2L18 8M18 2L12 8\"";
  return fmt::format("{}{} fill=\"none\" stroke=\"{}\" stroke-width=\"1.3\"/></svg>", kOpen, shape,
                     style.color);
}

/// Small figures take thinner strokes, or a loop disappears under its own line.
json line_style(const SeriesStyle& style, bool compact) {
  return {{"color", style.color},
          {"dash", style.dash},
          {"width", compact ? 0.65 * style.size : style.size}};
}

json marker_style(const SeriesStyle& style, bool small) {
  return {{"color", style.color},
          {"symbol", style.symbol},
          {"size", small ? 0.65 * style.size : style.size},
          {"line", {{"width", small ? 0.8 : 1.2}, {"color", style.color}}}};
}

}  // namespace

json plot_numbers(std::span<const double> values) {
  json numbers = json::array();
  for (const double value : values) {
    if (!std::isfinite(value)) {
      numbers.push_back(nullptr);
    } else {
      numbers.push_back(parse_number(format_number(value, kPlotDigits)).value_or(0.0));
    }
  }
  return numbers;
}

json trace(const SeriesStyle& style, std::span<const double> x, std::span<const double> y,
           bool compact) {
  json t = {{"type", "scatter"},          {"name", style.name},
            {"legendgroup", style.group}, {"x", plot_numbers(x)},
            {"y", plot_numbers(y)},       {"hovertemplate", "%{x:.4~g}, %{y:.4~g}"}};
  if (style.dash != nullptr) {
    t["mode"] = "lines";
    t["line"] = line_style(style, compact);
  } else {
    t["mode"] = "markers";
    t["marker"] = marker_style(style, x.size() > kCrowded);
  }
  return t;
}

json axis(const QuantityLabel& label, bool compact) {
  return {{"title",
           {{"text", label.with_unit()}, {"standoff", 6}, {"font", {{"size", compact ? 10 : 12}}}}},
          {"automargin", true},
          {"gridcolor", "#e6e9ed"},
          {"zerolinecolor", "#9aa4af"},
          {"zerolinewidth", 1},
          {"linecolor", "#9aa4af"},
          {"ticks", "outside"},
          {"ticklen", 3},
          {"tickcolor", "#9aa4af"},
          {"nticks", compact ? 5 : 7}};
}

json base_layout(bool compact) {
  return {
      {"showlegend", false},
      {"hovermode", "closest"},
      {"dragmode", "zoom"},
      {"paper_bgcolor", "#ffffff"},
      {"plot_bgcolor", "#ffffff"},
      {"font",
       {{"family", "system-ui, -apple-system, 'Segoe UI', 'Liberation Sans', Arial, sans-serif"},
        {"size", compact ? 10 : 11},
        {"color", "#27313c"}}},
      {"margin", {{"l", 8}, {"r", 10}, {"t", 8}, {"b", 8}}}};
}

std::string legend_html(std::span<const SeriesStyle> styles) {
  std::string html = "<div class=\"legend\">";
  for (const SeriesStyle& style : styles) {
    html += fmt::format(
        "<button type=\"button\" class=\"legend-entry\" data-group=\"{}\" aria-pressed=\"true\">"
        "{}{}</button>",
        style.group, swatch(style), style.name);
  }
  return html + "</div>\n";
}

}  // namespace pliant::report
