#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/model_comparison.h"
#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"

namespace pliant::report {

/// The models of a comparison in the order of its rows, each with the style of its bars.
std::vector<SeriesStyle> model_styles(const ModelComparison& comparison);

/// RMS errors of one session: a bar for each model, in a group for each variant. Fits that failed
/// leave a gap.
Figure model_fits_figure(const ModelComparison& comparison, std::size_t session);

}  // namespace pliant::report
