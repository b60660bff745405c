#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// Laws and nuisances that single experiments have told, to be fitted to all experiments together.
struct JointProblem {
  std::vector<const Experiment*> experiments;  ///< outlive the fit
  Material material;                  ///< complete for all of them, in the form of the laws
  std::vector<Unknown> unknowns;      ///< each begins where it was found
  Eigen::MatrixXd not_negative = {};  ///< as in LeastSquaresProblem
  RobustLoss loss = RobustLoss::none;
};

struct JointFit {
  Eigen::VectorXd values;  ///< of the unknowns
  Uncertainty uncertainty;
  double rms = 0;  ///< of the residuals in units of their noise
  bool converged = true;
  EquilibriumWork work;
};

/// One least-squares fit in which every experiment is weighed by its own noise, which the residuals
/// tell: weights and solution are found in turn. The covariance is one for all unknowns.
/// @throws SolverError where the experiments have no prediction to begin with
JointFit fit_jointly(const JointProblem& problem, const RunContext& context);

}  // namespace pliant
