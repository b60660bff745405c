#pragma once

#include <string>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/strip_shapes_file.h"

namespace pliant::report {

inline constexpr SeriesStyle kMeasuredShape = {"measured-shape", "measured points", "#56a0d3",
                                               nullptr,          "circle-open",     4.5};
inline constexpr SeriesStyle kPredictedShape = {"predicted-shape", "material", "#00538a",
                                                "solid",           nullptr,    2.0};

/// `radius 7.5 mm`
std::string setting_text(const StripShapes& shapes, double setting_mm);

/// The smallest, the middle and the largest setting, or all where they are fewer.
std::vector<double> chosen_settings(const StripShapes& shapes);

/// How one of the chosen settings looks; the names live as long as the settings' texts.
SeriesStyle setting_style(std::size_t number, const std::string& text);

/// Side view of strips, in mm alike along both axes: measured points and the predicted lines.
/// @param settings  those that are drawn
Figure side_view(const StripShapes& shapes, const std::vector<double>& settings, bool compact);

/// Curvature over the distance from the clamp of the chosen settings.
Figure curvature_figure(const StripShapes& shapes);

/// Moment over curvature of the chosen settings: bent to the cylinder, let go, and where the weight
/// of what hangs beyond each measured point says that the point is.
Figure moment_figure(const StripShapes& shapes);

/// Distance of the measured points from the predicted profile, over that from the clamp.
Figure distance_figure(const StripShapes& shapes);

}  // namespace pliant::report
