#pragma once

#include "pliant/estimation/law_fit.h"
#include "pliant/estimation/statistics/specimens.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// What the data says about the unknowns of a law's fit.
Uncertainty estimate_uncertainty(const ComponentProblem& problem, const LawFit& fit);

/// Raises the error of an unknown to what the spread between specimens makes it at least: the mean
/// of a fabric is known no better than its specimens agree.
void raise_error(Uncertainty& uncertainty, Eigen::Index unknown, const SpecimenSpread& spread,
                 const LawFit& fit);

}  // namespace pliant
