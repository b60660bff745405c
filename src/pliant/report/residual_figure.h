#pragma once

#include <cstddef>
#include <optional>

#include "pliant/report/figure.h"
#include "pliant/report/prediction.h"
#include "pliant/study/results.h"

namespace pliant::report {

enum class ResidualAbscissa { strain, time };

/// Measured minus predicted, of the rows that were used, against strain as it is shown, or against
/// time (the row number where no time was recorded).
/// @param membrane  measure of the strains, as far as it is known
Figure residual_figure(const ResultExperiment& experiment, const Prediction& prediction,
                       ResidualAbscissa abscissa, std::optional<MembraneMeasure> membrane,
                       std::size_t budget);

}  // namespace pliant::report
