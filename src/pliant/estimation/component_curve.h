#pragma once

#include <string>

#include <Eigen/Core>

#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/uncertainty.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// The errors of a law whose parameters are the unknowns from the first on.
/// @param uncertainty  outlives the result
ErrorOfLaw errors_of_law(const Uncertainty& uncertainty, Eigen::Index first);

/// The curve of a component from rest to a strain and back.
/// @param error_of  of its 95 % band; may be empty: NaN then, as where the data sees nothing
ComponentCurve component_curve(const std::string& component, const ComponentLaw& law,
                               double largest_strain, const ErrorOfLaw& error_of);

}  // namespace pliant
