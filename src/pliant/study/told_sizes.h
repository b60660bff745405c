#pragma once

#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// The defaults of an experiment, and the length and width that its data files tell above their
/// tables where the study tells none and all files agree. What was taken stands in
/// `ExperimentSpec::told`.
/// @param fields  of the experiment; which of them are there is all that is asked
SpecimenDefaults with_told_sizes(SpecimenDefaults defaults, const Fields& fields,
                                 const TestType& type, ExperimentSpec& experiment);

/// Asks about a length or width of the experiment that its data files tell otherwise above their
/// tables, where all files agree. The questions stand in `ExperimentSpec::doubts`.
/// @param experiment  its test is read
void doubt_stated_sizes(ExperimentSpec& experiment);

}  // namespace pliant
