#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// An unknown with what the data says about it.
ParameterEstimate estimate_of(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& values,
                              const Uncertainty& uncertainty, Eigen::Index unknown);

/// Gives an experiment of a result the noise that it was weighed by, and says where neighbouring
/// residuals go together.
/// @param part  of the problem
void take_noise(const Uncertainty& uncertainty, std::size_t part, ExperimentResult& row,
                StudyResult& result);

/// Gives an experiment the rows that the fit leaves by far, and warns of those and where its noise
/// was assumed or exceeds what is stated.
void doubt_rows(const Uncertainty& uncertainty, std::size_t part, ExperimentResult& row,
                std::vector<std::string>& warnings);

/// Names unknowns at their bounds in one warning.
void warn_of_bounds(const std::vector<std::string>& names, StudyResult& result);
/// Those of the material, then those of experiments.
void warn_of_bounds(StudyResult& result);

}  // namespace pliant
