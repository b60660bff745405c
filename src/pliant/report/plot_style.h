#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pliant/report/labels.h"

namespace pliant::report {

/// How one kind of series looks in every figure and legend. Loading and unloading differ by colour
/// and by dash (or symbol), so that they are told apart in grey print and by colour-blind readers.
struct SeriesStyle {
  const char* group;  ///< key that joins a legend entry with its traces
  const char* name;
  const char* color;
  const char* dash;    ///< plotly dash of a line; nullptr: markers
  const char* symbol;  ///< plotly symbol of markers, `square` for bars; nullptr: a line
  double size;         ///< width of the line or size of the markers, px
};

inline constexpr SeriesStyle kMeasuredLoad = {"measured-load", "measured, loading", "#56a0d3",
                                              nullptr,         "circle-open",       4.5};
inline constexpr SeriesStyle kMeasuredUnload = {"measured-unload", "measured, unloading", "#f0a24e",
                                                nullptr,           "triangle-down-open",  5.0};
inline constexpr SeriesStyle kMeasuredRest = {"measured-rest", "measured, at rest", "#8a94a0",
                                              nullptr,         "diamond-open",      4.5};
inline constexpr SeriesStyle kExcluded = {"excluded", "left out",    "#8a94a0",
                                          nullptr,    "x-thin-open", 5.0};
inline constexpr SeriesStyle kOutlier = {"outlier", "off by over 5 sd", "#c0392b",
                                         nullptr,   "diamond-open",     7.0};
inline constexpr SeriesStyle kPredictedLoad = {
    "predicted-load", "material, loading", "#00538a", "solid", nullptr, 2.0};
inline constexpr SeriesStyle kPredictedUnload = {
    "predicted-unload", "material, unloading", "#b34700", "6px,3px", nullptr, 2.0};
inline constexpr SeriesStyle kElastic = {
    "elastic", "without friction", "#555f6b", "2px,3px", nullptr, 1.6};
inline constexpr SeriesStyle kBand = {"band", "95 % band", "#00538a", "1px,2px", nullptr, 1.0};
inline constexpr SeriesStyle kEnvelope = {
    "envelope", "saturated friction", "#555f6b", "8px,3px,2px,3px", nullptr, 1.6};

/// Numbers rounded to what a picture can show; NaN becomes a gap.
nlohmann::json plot_numbers(std::span<const double> values);

/// A scatter trace in that style; `compact` for the small figures of page one.
nlohmann::json trace(const SeriesStyle& style, std::span<const double> x, std::span<const double> y,
                     bool compact = false);

/// An axis with that title.
nlohmann::json axis(const QuantityLabel& label, bool compact = false);

/// White, without a title, margins that grow with the tick labels.
nlohmann::json base_layout(bool compact = false);

/// A legend as HTML; each entry is a button that hides its series in the figures of its block.
std::string legend_html(std::span<const SeriesStyle> styles);

}  // namespace pliant::report
