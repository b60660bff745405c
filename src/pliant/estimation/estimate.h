#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// An unknown with what the data says about it.
ParameterEstimate estimate_of(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& values,
                              const Uncertainty& uncertainty, Eigen::Index unknown);

/// Gives the result of an experiment the noise that it was weighed by and the rows that the fit
/// leaves by far, and warns where the noise was assumed, exceeds what is stated, or rows stand out.
/// @param part  of the problem
void take_noise(const Uncertainty& uncertainty, std::size_t part, ExperimentResult& result,
                std::vector<std::string>& warnings);

}  // namespace pliant
