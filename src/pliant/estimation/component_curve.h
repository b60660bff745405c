#pragma once

#include <functional>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/uncertainty.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// Half width of the 95 % band of something with these derivatives by the parameters of a law;
/// nothing where the data does not see it.
using BandOfLaw = std::function<std::optional<double>(const Eigen::VectorXd& by_law)>;

/// The band of a law whose parameters are the unknowns from the first on.
/// @param uncertainty  outlives the result
BandOfLaw band_of(const Uncertainty& uncertainty, Eigen::Index first);

/// The curve of a component from rest to a strain and back.
/// @param band  may be empty: NaN then, as where the data sees nothing
ComponentCurve component_curve(const std::string& component, const ComponentLaw& law,
                               double largest_strain, const BandOfLaw& band);

}  // namespace pliant
