#pragma once

#include <string>

#include "pliant/report/figure.h"
#include "pliant/report/strip_shapes_file.h"
#include "pliant/study/results.h"

namespace pliant::report {

/// Figures of an experiment that measures the profiles of strips, with what it takes to read them,
/// as HTML.
/// It ends the block that its heading has begun, once the first pictures stand in it.
std::string shape_part(const ResultExperiment& experiment, const StripShapes& shapes,
                       FigureSheet& figures);

}  // namespace pliant::report
