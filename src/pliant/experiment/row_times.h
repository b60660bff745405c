#pragma once

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment.h"

namespace pliant {

/// Whether an experiment can be followed in time: its test can, and its rows tell when.
bool has_times(const Experiment& experiment);

/// Checks that an experiment tells when each of its rows was measured, which a law that flows with
/// time needs.
/// @param where  the study asks for such a law
/// @throws InputError for a test that follows no time, data without times, and times that go back
void require_times(const Experiment& experiment, const Location& where);

/// How long a measurement took (s); 0 where nothing is known of it.
double duration_of(const ExperimentInfo& info);

}  // namespace pliant
