#pragma once

#include "pliant/experiment/experiment_spec.h"

namespace pliant {

/// Whether the rows of an experiment are still those of the example that its test's template brings
/// along (test_template.h).
bool is_example_data(const ExperimentSpec& experiment);

}  // namespace pliant
