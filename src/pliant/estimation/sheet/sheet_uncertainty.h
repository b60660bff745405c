#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/sheet/sheet_fit.h"

namespace pliant {

/// What the data of an incremental fit says about its unknowns.
struct SheetUncertainty {
  std::vector<Unknown> unknowns;  ///< of all groups, then the cords of all tests
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;  ///< zero rows and columns where undetermined or fixed
  std::vector<char> determined;
  Eigen::VectorXd degrees;           ///< of freedom, >= 1: independent frames to judge the noise by
  std::vector<std::string> told_by;  ///< the tests, by their share of the information
  EquilibriumWork work;
};

/// Linearised uncertainty of stages that were fitted one after the other.
///
/// Each unknown makes the residuals of the tests of its last stage stand upright on its own
/// derivative: g(all unknowns) = sum of g_f = 0, g_f = J^T r being the part of a frame. With G =
/// dg/dp, G_f of a frame, the covariance is the sum over frames of d_f d_f^T, where d_f = (G -
/// G_f)^-1 g_f is by how much the fit would change without that frame (the jackknife; with G^-1
/// alone frames that tell much would seem to have little noise). That carries the errors of earlier
/// stages into later ones, and what is wrong in the same way in many nodes of a frame counts once.
/// What is wrong in the same way in many frames counts once, too: the share of a test is multiplied
/// by the number of frames whose parts go together (`integrated_autocorrelation`).
///
/// What a single frame tells alone is not determined: nothing says how well. A prior counts like
/// one more difference that has the noise of the measured ones.
SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context);

}  // namespace pliant
