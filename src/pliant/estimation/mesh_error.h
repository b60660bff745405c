#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/problem.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// How far the unknowns of a fit would move if its experiments were predicted on other meshes: one
/// step of Gauss and Newton from its solution.
/// @param known   of the fit
/// @param weight  of the rows of `other`, as `estimating_sums` has them
/// @return 0 for what is fixed; empty where the other meshes have no equilibria
Eigen::VectorXd moved_on(const Problem& other, const std::vector<Eigen::VectorXd>& weight,
                         const Problem& problem, const Eigen::VectorXd& values,
                         const Uncertainty& known, const ToldUnknowns& told);

}  // namespace pliant
