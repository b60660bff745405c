#pragma once

#include <string>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/model_fits.h"
#include "pliant/report/plot_style.h"

namespace pliant::report {

/// The models of a comparison in the order of its rows, each with the style of its bars.
std::vector<SeriesStyle> model_styles(const ModelFits& fits);

/// RMS errors of one session: a bar for each model, in a group for each variant. Fits that failed
/// leave a gap.
Figure model_fits_figure(const ModelFits& fits, std::size_t session);

}  // namespace pliant::report
