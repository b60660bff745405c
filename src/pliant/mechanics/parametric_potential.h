#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// A potential with parameters of a material, for estimation: how its forces and its history depend
/// on them along a quasi-static path ([T] Eqs. 3.7, 4.9).
class ParametricPotential : public HistoryPotential {
 public:
  /// @param all  the parameters of the whole system
  virtual void set_parameters(const Eigen::VectorXd& all) = 0;

  /// Chooses the parameters of the derivatives below.
  /// @param column_of  of each parameter of the whole system; -1 for no derivative by it
  virtual void differentiate_by(const std::vector<int>& column_of) = 0;

  /// Adds d gradient / d parameters at fixed positions, the history's dependence included.
  /// @param history_by_parameter   history_size() x chosen parameters
  /// @param gradient_by_parameter  3 points x chosen parameters (N per unit of each)
  virtual void add_force_sensitivity(const Evaluation& at,
                                     const Eigen::MatrixXd& history_by_parameter,
                                     Eigen::MatrixXd& gradient_by_parameter) const = 0;

  /// Carries d history / d parameters over an accepted step that ended at `at`.
  /// @param positions_by_parameter  3 points x parameters, at the end of the step
  virtual void advance_sensitivity(const Evaluation& at,
                                   const Eigen::MatrixXd& positions_by_parameter,
                                   Eigen::MatrixXd& history_by_parameter) const = 0;
};

}  // namespace pliant
