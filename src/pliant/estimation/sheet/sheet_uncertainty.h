#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/sheet/sheet_fit.h"

namespace pliant {

/// What the data of an incremental fit says about its unknowns.
struct SheetUncertainty {
  std::vector<SheetUnknown> unknowns;  ///< of all groups, then the cords of all tests
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;  ///< zero rows and columns where undetermined or fixed
  std::vector<char> determined;
  std::vector<std::string> told_by;  ///< the tests, by their share of the information
};

/// Linearised uncertainty of stages that were fitted one after the other.
///
/// Each unknown makes the residuals of the tests of its last stage stand upright on its own
/// derivative: g_i(all unknowns) = sum J_i r = 0. The covariance is G^-1 M G^-T with G = dg/dp,
/// which carries the errors of earlier stages into later ones, and M the sum over frames of the
/// products of their parts of g, neighbouring frames included with falling weight (Newey and West):
/// what is wrong with a model is wrong in the same way in many nodes and frames, and counts once.
/// A prior counts like one more difference that has the noise of the measured ones.
SheetUncertainty sheet_uncertainty(const SheetFit& fit, const std::vector<SheetStage>& plan,
                                   const FitOptions& options, const RunContext& context);

}  // namespace pliant
