#pragma once

#include <functional>
#include <string>

#include "pliant/base/journal.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// Digest of what was measured.
std::string digest_of(const ComponentExperiment& experiment);

/// Begins a fit in a journal: its first question names the settings and the data, so that the
/// progress of another fit is refused.
/// @param data  digests of what is fitted, in its order
void begin_fit(Journal& journal, const FitSettings& settings, const std::string& data);

/// Where a search ends, or ended before the fit was stopped.
LeastSquaresSummary answered(Journal& journal, const std::string& question,
                             const std::function<LeastSquaresSummary()>& search);

}  // namespace pliant
