#pragma once

#include "pliant/estimation/fit_result.h"
#include "pliant/study/study.h"

namespace pliant {

/// Adds to what a fit found what follows from all of it: how well the numbers of the material are
/// known, the digests of the data, the judgement, the order of its
/// figures.
void conclude_fit(const Study& study, StudyResult& result);

/// The same of an evaluation, which knows of no errors: the figures are those of the material.
void conclude_evaluation(const Study& study, StudyResult& result);

}  // namespace pliant
